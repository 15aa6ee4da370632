#include "meshalyzer/repair/holes/internal/loop_polygon.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

/// The limits of the steps of the bend are 41, 60, 76, 90, 104, 120, 139 and 180 degrees.
constexpr double kBendSteps = 8.0;
/// The share of the sum of squared edges in the cost of a triangle. All triangulations of a plane
/// region have the same area: this prefers short edges, by more than rounding errors and less than
/// any notable overlap.
constexpr double kObliquity = 1e-7;
/// A triangle with a smaller ratio of twice its area to the square of its longest edge may be
/// collinear within floating-point accuracy.
constexpr double kDoubtfulRatio = 1e-12;

/// Returns the exponent of the power of two that brings the largest coordinate to about 1.
int scale_of(const Soup& soup, const HoleLoop& loop) {
  double largest = 0.0;
  for (const Index v : loop.vertices) {
    largest = std::max(largest, soup.positions[v].cwiseAbs().maxCoeff());
  }
  return largest > 0.0 ? -std::ilogb(largest) : 0;
}

}  // namespace

LoopPolygon make_polygon(const PreparedMesh& mesh, const HoleLoop& loop, double degeneracy) {
  const CutMesh& cut = mesh.cut();
  const Soup& soup = mesh.soup();
  const int exponent = scale_of(soup, loop);
  LoopPolygon polygon{.vertices = loop.vertices,
                      .points = {},
                      .normals = std::vector<Vec3>(loop.size(), Vec3::Zero()),
                      .thin = std::ldexp(degeneracy, exponent)};
  polygon.points.reserve(loop.size());
  for (const Index v : loop.vertices) {
    polygon.points.push_back(times_power_of_two(soup.positions[v], exponent));
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const HalfedgeHandle h = loop.halfedges[i];
    if (!h.is_valid()) continue;
    const Index apex = file_ends(cut, cut.mesh.next_halfedge_handle(h))[1];
    const Vec3& next = polygon.points[i + 1 < loop.size() ? i + 1 : 0];
    polygon.normals[i] =
        unit_normal({next, polygon.points[i], times_power_of_two(soup.positions[apex], exponent)});
  }
  return polygon;
}

bool LoopRules::allows_chord(Index a, Index b) const {
  if (a == b || existing->contains(a, b)) return false;
  return std::none_of(bridges.begin(), bridges.end(), [&](const std::array<Index, 2>& e) {
    return (e[0] == a && e[1] == b) || (e[0] == b && e[1] == a);
  });
}

bool LoopRules::allows_triangle(const Triangle& corners) const {
  if (!is_in_complex(corners)) return false;
  return !std::binary_search(forbidden.begin(), forbidden.end(), sorted_corners(corners));
}

void LoopRules::forbid(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) t = sorted_corners(t);
  forbidden.insert(forbidden.end(), triangles.begin(), triangles.end());
  sort_unique(forbidden);
}

CandidateTriangle measure_candidate(const Vec3& a, const Vec3& b, const Vec3& c, double thin) {
  const double ab = (b - a).squaredNorm();
  const double bc = (c - b).squaredNorm();
  const double ca = (a - c).squaredNorm();
  const double longest = std::max({ab, bc, ca});
  const Vec3 normal = normal_of(a, b, c);
  const double twice_area = normal.norm();
  CandidateTriangle triangle;
  triangle.cost = 0.5 * twice_area + kObliquity * (ab + bc + ca);
  if (twice_area <= kDoubtfulRatio * longest) {
    if (are_collinear(a, b, c)) {
      triangle.fault = TriangleFault::Collinear;
      return triangle;
    }
    triangle.normal = unit_normal({a, b, c});
  } else {
    triangle.normal = normal / twice_area;
  }
  // The shortest altitude is the one on the longest edge.
  if (twice_area < thin * std::sqrt(longest)) triangle.fault = TriangleFault::Thin;
  return triangle;
}

double bend_between(const Vec3& normal_a, const Vec3& normal_b) {
  if (normal_a.isZero(0.0) || normal_b.isZero(0.0)) return 0.0;
  const double bend = 0.5 * (1.0 - normal_a.dot(normal_b));
  return std::floor(kBendSteps * bend) / kBendSteps;
}

}  // namespace meshalyzer
