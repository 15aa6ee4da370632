#include "support/punched_holes.h"

#include "meshalyzer/mesh/used_box.h"
#include "meshalyzer/repair/edits/apply_edits.h"
#include "meshalyzer/repair/holes/internal/fill_loop.h"
#include "meshalyzer/repair/holes/internal/triangulate_large_loop.h"
#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer::test {
namespace {

/// Each face is sampled at the nodes of a grid of so many steps along its sides.
constexpr int kSteps = 4;

std::array<Vec3, 3> corners(const Soup& soup, const Triangle& t) {
  return {soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]};
}

/// A point of a face, and the area that it stands for.
struct Sample {
  Vec3 point;
  double area;
};

std::vector<Sample> samples_of(const Soup& soup, std::span<const Triangle> faces) {
  constexpr double kNodes = (kSteps + 1) * (kSteps + 2) / 2.0;
  std::vector<Sample> samples;
  for (const Triangle& t : faces) {
    const std::array<Vec3, 3> c = corners(soup, t);
    const double area = 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm();
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const double u = static_cast<double>(i) / kSteps;
        const double v = static_cast<double>(j) / kSteps;
        samples.push_back({c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]), area / kNodes});
      }
    }
  }
  return samples;
}

double distance_to(const Soup& soup, std::span<const Triangle> faces, const Vec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : faces) {
    nearest = std::min(nearest, closest_on_triangle(corners(soup, t), point).distance);
  }
  return nearest;
}

/// Faces of a soup that has the vertices of the punched mesh first.
struct Filled {
  Soup soup;
  std::vector<Triangle> patch;
};

Filled fill_with_pass(const PunchedMesh& punched, FillShape shape) {
  const TrackedMesh tracked = track_mesh(punched.open);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances = resolve_tolerances({}, used_box(tracked.soup));
  const RepairLimits limits;
  const PassFunction fill =
      hole_filling({.at = punched.place, .shape = shape, .sheets = FillSheets::Yes});
  const PassResult result = fill({tracked.soup, tracked, mesh, tolerances, limits});
  const TrackedMesh after = apply_edits(tracked, result.edits);
  Filled filled{.soup = after.soup, .patch = {}};
  for (Index f = 0; f < after.soup.n_faces(); ++f) {
    if (after.origin_of_face(f) == kNoIndex) filled.patch.push_back(after.soup.triangles[f]);
  }
  return filled;
}

Filled fill_with_least_area(const PunchedMesh& punched) {
  const PreparedMesh mesh(punched.open);
  const HoleLoops found = find_hole_loops(mesh);
  const auto nearest = std::min_element(found.loops.begin(), found.loops.end(),
                                        [&](const HoleLoop& a, const HoleLoop& b) {
                                          return distance_from(punched.open, a, punched.place) <
                                                 distance_from(punched.open, b, punched.place);
                                        });
  if (found.loops.empty()) return {punched.open, {}};
  const ExistingEdges existing(mesh, found.loops);
  LoopRules rules{.existing = &existing};
  rules.weight = LoopWeight::Area;
  return {punched.open, triangulate_large_loop(make_polygon(mesh, *nearest, 0.0), rules)
                            .value_or(std::vector<Triangle>{})};
}

Filled fill(const PunchedMesh& punched, Filling filling) {
  switch (filling) {
    case Filling::Auto:
      return fill_with_pass(punched, FillShape::Auto);
    case Filling::Linear:
      return fill_with_pass(punched, FillShape::Linear);
    case Filling::Smooth:
      return fill_with_pass(punched, FillShape::Smooth);
    case Filling::LeastArea:
      break;
  }
  return fill_with_least_area(punched);
}

}  // namespace

PunchedMesh punch(const Soup& closed, Index vertex, double radius) {
  PunchedMesh punched{.open = closed, .lost = closed, .place = closed.positions[vertex]};
  punched.open.triangles.clear();
  punched.lost.triangles.clear();
  for (const Triangle& t : closed.triangles) {
    double reach = 0.0;
    for (const Index v : t) {
      reach = std::max(reach, (closed.positions[v] - punched.place).norm());
    }
    (reach <= radius ? punched.lost : punched.open).triangles.push_back(t);
    if (reach <= radius) punched.diameter = std::max(punched.diameter, 2.0 * reach);
  }
  return punched;
}

FillError fill_error(const PunchedMesh& punched, Filling filling) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Filled filled = fill(punched, filling);
  if (filled.patch.empty()) return {.mean = kInfinity, .largest = kInfinity};
  FillError error{.n_faces = filled.patch.size()};
  double area = 0.0;
  for (const Sample& sample : samples_of(filled.soup, filled.patch)) {
    const double distance = distance_to(punched.lost, punched.lost.triangles, sample.point);
    error.mean += sample.area * distance;
    area += sample.area;
    error.largest = std::max(error.largest, distance);
  }
  for (const Sample& sample : samples_of(punched.lost, punched.lost.triangles)) {
    error.largest = std::max(error.largest, distance_to(filled.soup, filled.patch, sample.point));
  }
  error.mean /= area * punched.diameter;
  error.largest /= punched.diameter;
  return error;
}

}  // namespace meshalyzer::test
