#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/topology/boundary.h"
#include "meshalyzer/topology/components.h"
#include "meshalyzer/topology/edges.h"
#include "support/random_soups.h"
#include "support/run_pass.h"
#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace meshalyzer {

/// The figures of a mesh that mending facets must not change.
struct TopologyCounts {
  std::size_t components = 0;
  std::size_t boundaries = 0;
  std::size_t non_manifold_vertices = 0;
  std::size_t flipped_edges = 0;
  long euler_characteristic = 0;

  friend bool operator==(const TopologyCounts&, const TopologyCounts&) = default;
};

[[nodiscard]] inline TopologyCounts topology_of(const Soup& soup) {
  const CutMesh cut = build(soup);
  std::vector<Index> used;
  for (const Triangle& t : soup.triangles) {
    if (is_in_complex(t)) used.insert(used.end(), t.begin(), t.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return {.components = find_components(cut).count,
          .boundaries = find_boundary_loops(cut).size(),
          .non_manifold_vertices = cut.side.non_manifold_vertices.size(),
          .flipped_edges = cut.side.flipped_edges.size(),
          .euler_characteristic = static_cast<long>(used.size()) - static_cast<long>(n_edges(cut)) +
                                  static_cast<long>(cut.mesh.n_faces())};
}

/// The faces that find_thin_facets() finds.
[[nodiscard]] inline std::vector<Index> thin_faces(const Soup& soup,
                                                   const ToleranceOptions& options = {}) {
  const PreparedMesh mesh(soup);
  std::vector<Index> faces;
  for (const Defect& defect : find_thin_facets(mesh, resolve_tolerances(options, box_of(soup)))) {
    faces.push_back(defect.faces.front());
  }
  return faces;
}

/// The face that crosses the edge from a to b in this direction; kNoIndex where there is none.
[[nodiscard]] inline Index face_crossing(const Soup& soup, Index a, Index b) {
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == a && t[(k + 1) % 3] == b) return f;
    }
  }
  return kNoIndex;
}

/// Puts a new vertex on the edge that leaves corner k of a face, and splits its faces there: with a
/// place near an end this makes needles; the surface stays what it was, but for rounding.
inline void split_edge(Soup& soup, Index face, std::size_t k, double share) {
  const Index a = soup.triangles[face][k];
  const Index b = soup.triangles[face][(k + 1) % 3];
  const auto middle = static_cast<Index>(soup.n_vertices());
  soup.positions.push_back(soup.positions[a] * (1.0 - share) + soup.positions[b] * share);
  for (const Index f : {face_crossing(soup, a, b), face_crossing(soup, b, a)}) {
    if (f == kNoIndex) continue;
    Triangle half = soup.triangles[f];
    for (Index& v : half) v = v == b ? middle : v;
    for (Index& v : soup.triangles[f]) v = v == a ? middle : v;
    soup.triangles.push_back(half);
  }
}

/// Puts a new vertex into a face, on the edge that leaves corner k but for rounding, and splits the
/// face in three: one of them is a cap.
inline void add_cap(Soup& soup, Index face, std::size_t k, double share) {
  const Triangle t = soup.triangles[face];
  const auto apex = static_cast<Index>(soup.n_vertices());
  soup.positions.push_back(soup.positions[t[k]] * (1.0 - share) +
                           soup.positions[t[(k + 1) % 3]] * share);
  soup.triangles[face] = {t[0], t[1], apex};
  soup.triangles.push_back({t[1], t[2], apex});
  soup.triangles.push_back({t[2], t[0], apex});
}

/// Two tetrahedra, one on the other, the tips of which are one: a waist of three vertices.
[[nodiscard]] inline Soup hourglass(const std::array<Vec3, 3>& waist) {
  Soup soup = shapes::make({waist[0],
                            waist[1],
                            waist[2],
                            {2, 0, 1},
                            {-1, 2, 1},
                            {-1, -2, 1},
                            {2, 0, -1},
                            {-1, 2, -1},
                            {-1, -2, -1}},
                           {{3, 4, 5}, {6, 8, 7}});
  for (Index k = 0; k < 3; ++k) {
    const Index next = (k + 1) % 3;
    soup.triangles.insert(
        soup.triangles.end(),
        {{k, next, 3 + k}, {next, 3 + next, 3 + k}, {next, k, 6 + k}, {next, 6 + k, 6 + next}});
  }
  return soup;
}

/// Needles and caps at n random places, which may lie in each other.
inline void hurt(Soup& soup, std::size_t n, std::mt19937& random) {
  for (std::size_t i = 0; i < n; ++i) {
    const Index face = below(random, static_cast<Index>(soup.n_faces()));
    const std::size_t k = below(random, 3);
    if (below(random, 2) == 0) {
      split_edge(soup, face, k, 1e-10);
    } else {
      add_cap(soup, face, k, 0.25 + 0.5 * below(random, 1000) / 1000.0);
    }
  }
}

}  // namespace meshalyzer
