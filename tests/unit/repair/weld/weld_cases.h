#pragma once

#include "meshalyzer/repair/passes.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/components.h"
#include "meshalyzer/topology/duplicate_faces.h"
#include "meshalyzer/topology/edges.h"
#include "support/run_pass.h"
#include "support/shapes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace meshalyzer {
/// The numbers that welding is to change, and those that it is not to change.
struct SeamTopology {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t border_edges = 0;
  std::size_t non_manifold_edges = 0;
  std::size_t non_manifold_vertices = 0;
  std::size_t flipped_edges = 0;
  std::size_t components = 0;
  std::size_t duplicate_faces = 0;

  friend bool operator==(const SeamTopology&, const SeamTopology&) = default;
};

inline SeamTopology seam_topology_of(const Soup& soup) {
  const CutMesh cut = build(soup);
  const std::vector<Index> valences = vertex_valences(cut);
  return {.vertices = valences.size() - static_cast<std::size_t>(
                                            std::count(valences.begin(), valences.end(), Index{0})),
          .edges = n_edges(cut),
          .faces = cut.mesh.n_faces(),
          .border_edges = find_border_edges(cut).size(),
          .non_manifold_edges = cut.side.non_manifold_edges.size(),
          .non_manifold_vertices = cut.side.non_manifold_vertices.size(),
          .flipped_edges = cut.side.flipped_edges.size(),
          .components = find_components(cut).count,
          .duplicate_faces = find_duplicate_faces(cut).size()};
}

/// Every face with three vertices of its own.
inline Soup unwelded(const Soup& soup) {
  Soup result;
  for (const Triangle& t : soup.triangles) {
    const auto first = static_cast<Index>(result.positions.size());
    for (const Index v : t) result.positions.push_back(soup.positions[v]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

/// Every coordinate moved by up to `amount` either way.
inline Soup jittered(Soup soup, double amount, std::uint32_t seed) {
  std::mt19937 random(seed);
  for (Vec3& p : soup.positions) {
    for (double& x : p) {
      x += amount * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0);
    }
  }
  return soup;
}

/// The corners of all faces, in order, by place.
inline std::vector<Vec3> corner_positions(const Soup& soup) {
  std::vector<Vec3> corners;
  for (const Triangle& t : soup.triangles) {
    for (const Index v : t) corners.push_back(soup.positions[v]);
  }
  return corners;
}

/// The mesh cut open along a chain of edges: the faces to the left of it get copies of its inner
/// vertices.
inline Soup slit_open(Soup soup, const std::vector<Index>& chain) {
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    const Index v = chain[i];
    // Turn round v from the edge to the next vertex of the chain to that of the one before.
    Index w = chain[i + 1];
    const auto copy = static_cast<Index>(soup.positions.size());
    const Index before = chain[i - 1];
    soup.positions.push_back(soup.positions[v]);
    const Index copy_of_before = i > 1 ? copy - 1 : before;
    while (w != before && w != copy_of_before) {
      for (Triangle& t : soup.triangles) {
        const auto at = std::find(t.begin(), t.end(), v);
        if (at == t.end()) continue;
        const auto k = static_cast<std::size_t>(at - t.begin());
        if (t[(k + 1) % 3] != w) continue;
        w = t[(k + 2) % 3];
        t[k] = copy;
        break;
      }
    }
  }
  return soup;
}

inline PassFunction weld(double within) {
  return [within](PassInput input) {
    input.length = std::min(within, input.limits.max_deviation);
    return weld_borders(input, within);
  };
}

inline RepairLimits any_distance() {
  return {.max_deviation = 1e300, .fixed_vertices = {}, .groups = Groups::Names};
}

inline Soup welded(const Soup& soup, double within) {
  return run_pass(soup, weld(within), any_distance()).tracked.soup;
}

inline Soup two_triangles_apart(double gap) {
  return shapes::make({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0, -gap, 0}, {1, -gap, 0}, {0.5, -1, 0}},
                      {{0, 1, 2}, {4, 3, 5}});
}

inline std::vector<Soup> closed_shapes() {
  return {shapes::icosphere(2), shapes::torus(3, 1, 9, 7), shapes::genus_block(3), shapes::cube(),
          shapes::nested_cubes(shapes::InnerShell::Cavity)};
}

/// Two unit squares on either side of y = 0, `gap` apart; the border of the lower one has vertices
/// at these x, all of them the third corner of a face with (0.5, -1, 0).
inline Soup crack_with_junctions(double gap, const std::vector<double>& inner) {
  Soup soup =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0, -gap, 0}}, {{0, 1, 2}});
  for (const double x : inner) soup.positions.emplace_back(x, -gap, 0);
  soup.positions.emplace_back(1, -gap, 0);
  for (Index v = 4; v + 1 < soup.positions.size(); ++v) soup.triangles.push_back({3, v + 1, v});
  return soup;
}

/// Two fans that meet along the x axis from 0 to 1: the upper one has border vertices at `above`
/// besides the ends, the lower one, which is lower by `gap`, at `below`.
inline Soup interleaved_crack(double gap, const std::vector<double>& above,
                              const std::vector<double>& below) {
  Soup soup = shapes::make({{0.5, 1, 0}, {0.5, -1, 0}}, {});
  const auto add_side = [&](std::vector<double> places, double y, Index hub) {
    places.insert(places.begin(), 0.0);
    places.push_back(1.0);
    const auto first = static_cast<Index>(soup.n_vertices());
    for (const double x : places) soup.positions.emplace_back(x, y, 0.0);
    for (Index v = first; v + 1 < soup.n_vertices(); ++v) {
      soup.triangles.push_back(hub == 0 ? Triangle{v, v + 1, hub} : Triangle{v + 1, v, hub});
    }
  };
  add_side(above, 0.0, 0);
  add_side(below, -gap, 1);
  return shapes::make(std::move(soup.positions), std::move(soup.triangles));
}

}  // namespace meshalyzer
