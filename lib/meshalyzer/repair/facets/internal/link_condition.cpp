#include "meshalyzer/repair/facets/internal/link_condition.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/base/triangle_vertices.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// A side of a face at a vertex: the neighbour at its other end, and the index of the face.
using SideAtVertex = std::pair<Index, Index>;

/// Returns all sides, those to the same neighbour side by side.
std::vector<SideAtVertex> find_sides(const WorkingMesh& mesh, Index vertex) {
  std::vector<SideAtVertex> sides;
  const auto faces = mesh.faces_at(vertex);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const Index v : mesh.triangle(faces[i])) {
      if (v != vertex) sides.emplace_back(v, static_cast<Index>(i));
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// The fans of a vertex, and the runs of sides that are edges without exactly two faces.
struct FanCount {
  DisjointSets fan_of;
  std::vector<std::span<const SideAtVertex>> odd_edges;
};

FanCount join_fans(std::span<const SideAtVertex> sides, std::size_t n_faces) {
  FanCount result{DisjointSets(n_faces), {}};
  for_each_run(sides, &SideAtVertex::first, [&](std::span<const SideAtVertex> edge) {
    if (edge.size() == 2) {
      result.fan_of.unite(edge[0].second, edge[1].second);
    } else {
      result.odd_edges.push_back(edge);
    }
  });
  return result;
}

std::vector<Index> fans_at(FanCount& fans, std::span<const SideAtVertex> edge) {
  std::vector<Index> result;
  for (const SideAtVertex& side : edge) result.push_back(fans.fan_of.find(side.second));
  std::sort(result.begin(), result.end());
  return result;
}

bool has_twice(const std::vector<Index>& ascending) {
  return std::adjacent_find(ascending.begin(), ascending.end()) != ascending.end();
}

/// Returns the vertices opposite to an edge, ascending.
std::vector<Index> apexes(const WorkingMesh& mesh, Index a, Index b) {
  std::vector<Index> result;
  for (const Index f : mesh.faces_at(a, b)) {
    result.push_back(third_corner(mesh.triangle(f), a, b));
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Tells whether two vertices have nothing in common except the neighbourhood of their edge.
bool is_link_shared_by_edge_alone(const WorkingMesh& mesh, Index gone, Index kept,
                                  const std::vector<FinTip>& fins, MendStep& step) {
  std::vector<Index> common = apexes(mesh, gone, kept);
  for (const FinTip& fin : fins) {
    std::replace(common.begin(), common.end(), fin.tip, fin.third_neighbour);
  }
  std::sort(common.begin(), common.end());
  if (has_twice(common)) return false;
  const auto is_tip = [&](Index v) {
    return std::any_of(fins.begin(), fins.end(), [&](const FinTip& fin) { return fin.tip == v; });
  };
  const auto is_common = [&](Index v) {
    return std::binary_search(common.begin(), common.end(), v);
  };
  for (const Index v : mesh.neighbours(gone)) {
    if (v == kept || is_tip(v)) continue;
    step.read_edges.push_back({kept, v});
    if (!is_common(v) && mesh.are_joined(kept, v)) return false;
  }
  for (const Index f : mesh.faces_at(gone)) {
    Triangle t = mesh.triangle(f);
    std::swap(t[0], *std::find(t.begin(), t.end(), gone));
    if (!is_common(t[1]) || !is_common(t[2])) continue;
    const std::vector<Index> beyond = apexes(mesh, t[1], t[2]);
    if (std::binary_search(beyond.begin(), beyond.end(), kept)) return false;
  }
  return true;
}

}  // namespace

VertexSurroundings look_round(const WorkingMesh& mesh, Index vertex) {
  const std::size_t n_faces = mesh.faces_at(vertex).size();
  const std::vector<SideAtVertex> sides = find_sides(mesh, vertex);
  FanCount fans = join_fans(sides, n_faces);
  std::size_t n_fans = 0;
  for (Index i = 0; i < n_faces; ++i) n_fans += fans.fan_of.find(i) == i ? 1U : 0U;
  VertexSurroundings result;
  if (fans.odd_edges.empty() && n_fans == 1) {
    result.kind = VertexKind::Plain;
  } else if (fans.odd_edges.size() == 2) {
    const std::vector<Index> first = fans_at(fans, fans.odd_edges[0]);
    // Each fan occurs once at each of the two edges, and there is no other fan.
    if (first.size() == n_fans && !has_twice(first) && fans_at(fans, fans.odd_edges[1]) == first) {
      result.kind = VertexKind::Ridge;
      result.along = {fans.odd_edges[0][0].first, fans.odd_edges[1][0].first};
    }
  }
  return result;
}

std::vector<FinTip> fin_tips_at(const WorkingMesh& mesh, Index a, Index b, MendStep& step) {
  std::vector<FinTip> fins;
  for (const Index tip : apexes(mesh, a, b)) {
    if (mesh.faces_at(tip).size() != 3) continue;
    const std::vector<Index> neighbours = mesh.neighbours(tip);
    if (neighbours.size() != 3 || look_round(mesh, tip).kind != VertexKind::Plain) continue;
    step.read_vertices.push_back(tip);
    const auto third = std::find_if(neighbours.begin(), neighbours.end(),
                                    [&](Index v) { return v != a && v != b; });
    fins.push_back({tip, *third});
  }
  return fins;
}

bool may_merge(const WorkingMesh& mesh, const std::array<Index, 2>& gone_and_kept,
               const std::vector<FinTip>& fins, MendStep& step) {
  const auto [gone, kept] = gone_and_kept;
  step.read_vertices.push_back(gone);
  const VertexSurroundings round = look_round(mesh, gone);
  if (round.kind == VertexKind::Corner) return false;
  if (!is_link_shared_by_edge_alone(mesh, gone, kept, fins, step)) return false;
  if (round.kind == VertexKind::Plain) return true;
  // The edge is part of the curve, and the curve must not be a triangle of three of its edges.
  if (round.along[0] != kept && round.along[1] != kept) return false;
  const Index other = round.along[0] == kept ? round.along[1] : round.along[0];
  const std::size_t n_beyond = mesh.faces_at(kept, other).size();
  return n_beyond == 0 || n_beyond == 2;
}

}  // namespace meshalyzer
