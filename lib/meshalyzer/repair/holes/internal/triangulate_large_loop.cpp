#include "meshalyzer/repair/holes/internal/triangulate_large_loop.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/plane_view.h"
#include "meshalyzer/repair/holes/internal/ear_cutter.h"
#include "meshalyzer/repair/holes/internal/patch_edges.h"
#include "meshalyzer/repair/holes/internal/triangulate_loop.h"
#include "meshalyzer/repair/holes/internal/triangulation_memory.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace meshalyzer {
namespace {

/// The factor for the squared chord of an ear that is thin, or bent from the surface round its tip:
/// it is cut later, but not so late that others grow across the loop meanwhile.
constexpr double kBadEarFactor = 16.0;

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

/// Returns the sum of the normals of the faces beyond the two edges at a corner.
Vec3 normal_round(const LoopPolygon& polygon, std::size_t corner) {
  return polygon.normals[corner] + polygon.normals[corner == 0 ? polygon.size() - 1 : corner - 1];
}

/// Tells whether an ear is neither thin nor, unless the loop is taken for flat, bent from the
/// surface round its tip. Along a straight border round a body, thin fans from the end of the
/// border are bent.
bool is_good(const LoopPolygon& polygon, LoopWeight weight, const Triangle& ear) {
  const CandidateTriangle measured = measure_ear(polygon, ear);
  if (weight == LoopWeight::Flat) return measured.fault == TriangleFault::None;
  const Vec3 round = normal_round(polygon, ear[1]).stableNormalized();
  return measured.fault == TriangleFault::None && bend_between(measured.normal, round) == 0.0;
}

/// Returns rules that cut the ears with the shortest chord first, bad ones later.
EarRules ear_rules(const LoopPolygon& polygon, const LoopRules& rules) {
  return {.cost =
              [&polygon, &rules](const Triangle& ear) {
                const double chord =
                    (polygon.points[ear[2]] - polygon.points[ear[0]]).squaredNorm();
                return is_good(polygon, rules.weight, ear) ? chord : kBadEarFactor * chord;
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

/// Returns for each corner the projection that shows the faces beyond its edges best, or a given
/// one where there are none.
std::vector<PlaneView> views_of_surface(const LoopPolygon& polygon, const PlaneView& otherwise) {
  std::vector<PlaneView> views;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 normal = normal_round(polygon, i);
    const Axis axis = longest_axis(normal);
    const bool is_negative = normal[static_cast<Eigen::Index>(axis)] < 0.0;
    views.push_back(normal.isZero(0.0) ? otherwise : PlaneView{axis, is_negative ? -1 : 1});
  }
  return views;
}

std::optional<std::vector<Triangle>> triangulate_small(const LoopPolygon& polygon,
                                                       const LoopRules& rules,
                                                       TriangulationMemory* memory) {
  return memory == nullptr ? triangulate_loop(polygon, rules) : memory->triangulate(polygon, rules);
}

std::optional<std::vector<Triangle>> triangulate_in_views(const LoopPolygon& polygon,
                                                          const LoopRules& rules,
                                                          std::vector<PlaneView> views,
                                                          TriangulationMemory* memory) {
  const std::size_t n_rest = rules.weight == LoopWeight::Flat ? 3 : kSmallLoop;
  const EarRules by_chord = ear_rules(polygon, rules);
  EarCutter cutter(polygon.points, std::move(views), by_chord);
  cut_ears_down_to(n_rest, cutter);
  const LoopPolygon rest = rest_of(polygon, cutter);
  if (rest.size() > n_rest) return std::nullopt;
  const auto last = triangulate_small(rest, rules, memory);
  if (!last) return std::nullopt;
  std::vector<Triangle> triangles;
  for (const Triangle& ear : cutter.triangles()) triangles.push_back(vertices_of(polygon, ear));
  triangles.insert(triangles.end(), last->begin(), last->end());
  return triangles;
}

/// Returns how sharply triangles bend from the faces beyond the loop: the sum of the edges' lengths
/// times 1 - the cosine of the angle.
double bend_at_rim(const LoopPolygon& polygon, const std::vector<Triangle>& triangles) {
  std::unordered_map<Index, Vec3> point_of;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    point_of[polygon.vertices[i]] = polygon.points[i];
  }
  const PatchEdges edges({.triangles = triangles, .added = {}});
  double bend = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = i + 1 < polygon.size() ? i + 1 : 0;
    const Index face = edges.face_at({polygon.vertices[i], polygon.vertices[next]});
    if (face == kNoIndex) continue;
    const Triangle& t = triangles[face];
    const Vec3 normal = normal_of(point_of[t[0]], point_of[t[1]], point_of[t[2]]);
    bend += (polygon.points[next] - polygon.points[i]).norm() *
            (1.0 - normal.stableNormalized().dot(polygon.normals[i]));
  }
  return bend;
}

}  // namespace

std::optional<std::vector<Triangle>> triangulate_large_loop(const LoopPolygon& polygon,
                                                            const LoopRules& rules,
                                                            TriangulationMemory* memory) {
  if (polygon.size() <= (rules.weight == LoopWeight::Flat ? 3 : kSmallLoop)) {
    return triangulate_small(polygon, rules, memory);
  }
  const PlaneView whole = choose_view(polygon.points);
  auto in_one_view = triangulate_in_views(polygon, rules, {whole}, memory);
  if (rules.weight == LoopWeight::Flat) return in_one_view;
  std::vector<PlaneView> views = views_of_surface(polygon, whole);
  const bool is_seen_whole = std::all_of(views.begin(), views.end(), [&](const PlaneView& view) {
    return view.dropped == whole.dropped && view.sense == whole.sense;
  });
  if (is_seen_whole) return in_one_view;
  auto in_views = triangulate_in_views(polygon, rules, std::move(views), memory);
  if (!in_one_view || !in_views) return in_one_view ? in_one_view : in_views;
  return bend_at_rim(polygon, *in_views) < bend_at_rim(polygon, *in_one_view) ? in_views
                                                                              : in_one_view;
}

}  // namespace meshalyzer
