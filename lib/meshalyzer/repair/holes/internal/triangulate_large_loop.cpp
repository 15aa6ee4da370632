#include "meshalyzer/repair/holes/internal/triangulate_large_loop.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/plane_view.h"
#include "meshalyzer/repair/holes/internal/ear_cutter.h"
#include "meshalyzer/repair/holes/internal/triangulate_loop.h"

#include <utility>

namespace meshalyzer {
namespace {

/// The factor for the squared chord of a thin ear: it is cut later, but not so late that others
/// grow across the loop meanwhile.
constexpr double kThinFactor = 16.0;

/// Returns the projection that shows a loop best.
PlaneView choose_view(const std::vector<Vec3>& points) {
  // Positions are relative to one of the points, so that a loop far from the origin keeps its
  // digits.
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    area += normal_of(points[0], points[i], points[i + 1]);
  }
  const Axis axis = longest_axis(area);
  return {axis, area[static_cast<Eigen::Index>(axis)] < 0.0 ? -1 : 1};
}

CandidateTriangle measure_ear(const LoopPolygon& polygon, const Triangle& ear) {
  return measure_candidate(polygon.points[ear[0]], polygon.points[ear[1]], polygon.points[ear[2]],
                           polygon.thin);
}

Triangle vertices_of(const LoopPolygon& polygon, const Triangle& ear) {
  return {polygon.vertices[ear[0]], polygon.vertices[ear[1]], polygon.vertices[ear[2]]};
}

/// Returns rules that cut the ears with the shortest chord first, thin ones later.
EarRules ear_rules(const LoopPolygon& polygon, const LoopRules& rules) {
  return {.cost =
              [&polygon](const Triangle& ear) {
                const double chord =
                    (polygon.points[ear[2]] - polygon.points[ear[0]]).squaredNorm();
                const bool is_good = measure_ear(polygon, ear).fault == TriangleFault::None;
                return is_good ? chord : kThinFactor * chord;
              },
          .allows =
              [&polygon, &rules](const Triangle& ear) {
                const Triangle t = vertices_of(polygon, ear);
                return rules.allows_chord(t[0], t[2]) && rules.allows_triangle(t);
              }};
}

/// Cuts ears until the given number of corners is left, or none can be cut.
void cut_ears_down_to(std::size_t n_wanted, EarCutter& cutter) {
  EarDemand demand = EarDemand::ConvexAndEmpty;
  while (cutter.n_left() > n_wanted) {
    const std::size_t n_before = cutter.n_left();
    cutter.cut(demand, n_wanted);
    // Cutting may make ears of corners that were rejected before, but seldom many.
    if (n_before - cutter.n_left() > n_before / 16) continue;
    if (demand == EarDemand::Nothing) return;
    demand = demand == EarDemand::ConvexAndEmpty ? EarDemand::Convex : EarDemand::Nothing;
  }
}

/// Returns the loop that remains after cutting.
LoopPolygon rest_of(const LoopPolygon& polygon, const EarCutter& cutter) {
  std::vector<Vec3> normals = polygon.normals;
  for (const Triangle& ear : cutter.triangles()) {
    normals[ear[0]] = measure_ear(polygon, ear).normal;
  }
  LoopPolygon rest{.vertices = {}, .points = {}, .normals = {}, .thin = polygon.thin};
  for (const Index i : cutter.corners_left()) {
    rest.vertices.push_back(polygon.vertices[i]);
    rest.points.push_back(polygon.points[i]);
    rest.normals.push_back(normals[i]);
  }
  return rest;
}

}  // namespace

std::optional<std::vector<Triangle>> triangulate_large_loop(const LoopPolygon& polygon,
                                                            const LoopRules& rules) {
  const std::size_t n_rest = rules.weight == LoopWeight::Flat ? 3 : kSmallLoop;
  if (polygon.size() <= n_rest) return triangulate_loop(polygon, rules);
  const EarRules by_chord = ear_rules(polygon, rules);
  EarCutter cutter(polygon.points, choose_view(polygon.points), by_chord);
  cut_ears_down_to(n_rest, cutter);
  const LoopPolygon rest = rest_of(polygon, cutter);
  if (rest.size() > n_rest) return std::nullopt;
  const auto last = triangulate_loop(rest, rules);
  if (!last) return std::nullopt;
  std::vector<Triangle> triangles;
  for (const Triangle& ear : cutter.triangles()) triangles.push_back(vertices_of(polygon, ear));
  triangles.insert(triangles.end(), last->begin(), last->end());
  return triangles;
}

}  // namespace meshalyzer
