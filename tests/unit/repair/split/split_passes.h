#pragma once

#include "meshalyzer/repair/passes.h"
#include "meshalyzer/topology/components.h"
#include "meshalyzer/topology/edges.h"
#include "support/intersecting_pairs.h"
#include "support/run_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace meshalyzer {

inline PassResult split_edges_and_walls(const PassInput& input) {
  return split_edges(input, SharedWalls::Doubled);
}

/// Cuts a mesh wherever it is not manifold, and leaves the copies where they are.
[[nodiscard]] inline PassRun split(const Soup& soup) {
  return run_pass(run_pass(soup, split_edges_and_walls).tracked.soup, split_vertices);
}

/// The same, and then moves the copies apart.
[[nodiscard]] inline PassRun split_and_part(const Soup& soup) {
  return run_pass(split(soup).tracked.soup, part_contacts);
}

[[nodiscard]] inline std::size_t n_components(const Soup& soup) {
  return find_components(build(soup)).count;
}

[[nodiscard]] inline std::size_t n_border_edges(const Soup& soup) {
  const std::vector<EdgeKind> kinds = classify_edges(build(soup));
  return static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), EdgeKind::Border));
}

/// Returns the volume of each component, ascending.
[[nodiscard]] inline std::vector<double> volumes(const Soup& soup) {
  const CutMesh cut = build(soup);
  const Components components = find_components(cut);
  std::vector<double> result(components.count, 0.0);
  for (std::size_t f = 0; f < cut.side.faces.size(); ++f) {
    const Triangle& t = soup.triangles[cut.side.faces[f]];
    const Vec3 normal = soup.positions[t[1]].cross(soup.positions[t[2]]);
    result[components.of_face[f]] += soup.positions[t[0]].dot(normal);
  }
  // Whole numbers up to here, for meshes of whole numbers.
  for (double& volume : result) volume /= 6;
  std::sort(result.begin(), result.end());
  return result;
}

/// No edge with more than two faces, no vertex with several fans.
[[nodiscard]] inline bool is_manifold(const Soup& soup) {
  const CutMesh cut = build(soup);
  return cut.side.non_manifold_edges.size() == 0 && cut.side.non_manifold_vertices.empty();
}

/// Tells whether one mesh is the other with copies of some vertices: each face has its corners at
/// the very same places, the first vertices are the same, and none is alone.
[[nodiscard]] inline bool is_cut_version(const Soup& cut, const Soup& whole) {
  if (cut.triangles.size() != whole.triangles.size()) return false;
  if (!std::equal(whole.positions.begin(), whole.positions.end(), cut.positions.begin())) {
    return false;
  }
  for (std::size_t f = 0; f < cut.triangles.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (cut.positions[cut.triangles[f][i]] != whole.positions[whole.triangles[f][i]])
        return false;
    }
  }
  return true;
}

/// Limits under which some vertices of the borders of a body's faces must stay as they are.
[[nodiscard]] inline RepairLimits body_limits(const Soup& soup, const std::vector<Index>& fixed) {
  RepairLimits limits = wide_limits(soup);
  limits.groups = Groups::Faces;
  limits.fixed_vertices.assign(soup.n_vertices(), 0);
  for (const Index v : fixed) limits.fixed_vertices[v] = 1;
  return limits;
}

}  // namespace meshalyzer
