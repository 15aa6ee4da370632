#include "meshalyzer/repair/driver/internal/face_cover.h"

#include "meshalyzer/base/lexicographic.h"
#include "meshalyzer/repair/driver/internal/face_distance.h"
#include "meshalyzer/spatial/closest_point.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace meshalyzer {

namespace {

using Segment = std::array<Vec3, 2>;

Vec3 normal_of(const Corners& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

/// A triangle's inscribed circle.
struct Incircle {
  Vec3 centre;
  double radius = 0.0;
};

Incircle incircle_of(const Corners& t) {
  const double a = (t[2] - t[1]).norm();
  const double b = (t[0] - t[2]).norm();
  const double c = (t[1] - t[0]).norm();
  const double perimeter = a + b + c;
  return {(a * t[0] + b * t[1] + c * t[2]) / perimeter, normal_of(t).norm() / perimeter};
}

/// An edge of a part, the end that comes first in front, and how often parts go along it, those
/// that go from the other end counted negative.
struct CountedEdge {
  Segment ends;
  int count = 0;
};

/// The edges that the boundaries of the parts, each turned to the side of the normal, add up to.
std::vector<CountedEdge> sum_of_boundaries(std::span<const Corners> parts, const Vec3& normal) {
  std::vector<CountedEdge> edges;
  edges.reserve(3 * parts.size());
  for (const Corners& part : parts) {
    const int sign = normal_of(part).dot(normal) < 0.0 ? -1 : 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& from = part[i];
      const Vec3& to = part[(i + 1) % 3];
      edges.push_back(lexicographically_less(from, to) ? CountedEdge{{from, to}, sign}
                                                       : CountedEdge{{to, from}, -sign});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const CountedEdge& a, const CountedEdge& b) {
    return std::lexicographical_compare(a.ends.begin(), a.ends.end(), b.ends.begin(), b.ends.end(),
                                        lexicographically_less);
  });
  std::size_t n = 0;
  for (const CountedEdge& edge : edges) {
    if (n > 0 && edges[n - 1].ends == edge.ends) {
      edges[n - 1].count += edge.count;
    } else {
      edges[n++] = edge;
    }
  }
  edges.resize(n);
  std::erase_if(edges, [](const CountedEdge& edge) { return edge.count == 0; });
  return edges;
}

/// Returns how far a segment is from the nearest edge of a face, at its farther end.
double distance_from_edge(const Segment& segment, const Corners& face) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Corners edge{face[i], face[(i + 1) % 3], face[(i + 1) % 3]};
    nearest = std::min(nearest, std::max(closest_on_triangle(edge, segment[0]).distance,
                                         closest_on_triangle(edge, segment[1]).distance));
  }
  return nearest;
}

/// Tells whether a point lies in a triangle, seen along a direction.
bool contains(const Corners& t, const Vec3& point, const Vec3& direction) {
  const double side = normal_of(t).dot(direction) < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 normal = (t[(i + 1) % 3] - t[i]).cross(point - t[i]);
    if (side * normal.dot(direction) < 0.0) return false;
  }
  return true;
}

}  // namespace

std::optional<double> distance_from_parts(const Corners& face, std::span<const Corners> parts) {
  /// How much larger the incircle must be than the parts are inaccurate.
  constexpr double kMargin = 4.0;
  const Vec3 normal = normal_of(face);
  double inaccuracy = 0.0;
  for (const Corners& part : parts) {
    inaccuracy = std::max(inaccuracy, largest_distance(part, face));
  }
  for (const CountedEdge& edge : sum_of_boundaries(parts, normal)) {
    inaccuracy = std::max(inaccuracy, distance_from_edge(edge.ends, face));
  }
  const Incircle circle = incircle_of(face);
  const bool is_covered = circle.radius > kMargin * inaccuracy &&
                          std::any_of(parts.begin(), parts.end(), [&](const Corners& part) {
                            return contains(part, circle.centre, normal);
                          });
  if (!is_covered) return std::nullopt;
  // Shrunk towards the incentre the face is as deep as that; nothing moves farther than a corner.
  double farthest = 0.0;
  for (const Vec3& corner : face) farthest = std::max(farthest, (corner - circle.centre).norm());
  return inaccuracy * (1.0 + farthest / circle.radius);
}

}  // namespace meshalyzer
