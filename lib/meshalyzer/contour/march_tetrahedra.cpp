#include "meshalyzer/contour/march_tetrahedra.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meshalyzer {
namespace {

/// Vertices of a contour lie at multiples of 1/kParts of an edge, and keep a distance from its
/// ends.
constexpr int kParts = 256;
constexpr int kLeastParts = 8;

std::size_t place_in(const std::vector<std::uint64_t>& sorted, std::uint64_t key) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), key) -
                                  sorted.begin());
}

bool is_on_cube(const LatticePoint& p) {
  return std::any_of(p.begin(), p.end(),
                     [](std::int32_t x) { return x == 0 || x == BisectionGrid::kSize; });
}

/// An edge of the grid, from the vertex that lies in the region to the one that does not.
struct CrossedEdge {
  Index inside = 0;
  Index outside = 0;

  [[nodiscard]] std::uint64_t key() const { return std::uint64_t{inside} << 32U | outside; }
};

/// A tetrahedron with the labels of its vertices.
struct LabelledTetrahedron {
  /// The vertices, those in the region first, as an even permutation of a positively oriented
  /// tetrahedron.
  std::array<Index, 4> vertices{};
  int n_inside = 0;

  /// Returns the edges that the contour crosses, counter-clockwise round its polygon as seen from
  /// outside the region.
  [[nodiscard]] std::array<CrossedEdge, 4> polygon() const {
    const auto& [a, b, c, d] = vertices;
    switch (n_inside) {
      case 1:
        return {{{a, b}, {a, c}, {a, d}}};
      case 2:
        return {{{a, c}, {a, d}, {b, d}, {b, c}}};
      default:
        return {{{a, d}, {b, d}, {c, d}}};
    }
  }
  [[nodiscard]] bool is_crossed() const { return n_inside != 0 && n_inside != 4; }
  [[nodiscard]] std::size_t n_corners() const { return n_inside == 2 ? 4 : 3; }
};

/// Returns exactly six times the volume, positive if the normal of corners 1, 2, 3 points away from
/// corner 0.
std::int64_t orientation(const GridTetrahedron& t) {
  std::array<std::array<std::int64_t, 3>, 3> e;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) e[i][k] = t.corners[i + 1][k] - t.corners[0][k];
  }
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
         e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

LabelledTetrahedron labelled(const GridTetrahedron& t, const GridLabels& labels) {
  LabelledTetrahedron result;
  std::array<std::uint8_t, 4> inside{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t v = place_in(labels.vertices, packed(t.corners[i]));
    result.vertices[i] = static_cast<Index>(v);
    inside[i] = labels.inside[v];
    result.n_inside += inside[i];
  }
  bool is_even = orientation(t) > 0;
  const auto exchange = [&](std::size_t i, std::size_t j) {
    std::swap(inside[i], inside[j]);
    std::swap(result.vertices[i], result.vertices[j]);
    is_even = !is_even;
  };
  for (std::size_t i = 0, next = 0; i < 4; ++i) {
    if (inside[i] == 0) continue;
    if (i != next) exchange(next, i);
    ++next;
  }
  if (!is_even) {
    // Two vertices of the same label are exchanged.
    if (result.n_inside >= 2) {
      exchange(0, 1);
    } else {
      exchange(2, 3);
    }
  }
  return result;
}

Vec3 vertex_on(const BisectionGrid& grid, const GridLabels& labels, const Region& region,
               const CrossedEdge& edge) {
  const LatticePoint a = unpacked(labels.vertices[edge.inside]);
  const LatticePoint b = unpacked(labels.vertices[edge.outside]);
  const double share = region.crossing(grid.place(a), grid.place(b));
  const double parts = std::isnan(share) ? kParts / 2.0 : std::round(share * kParts);
  const double n = std::clamp<double>(parts, kLeastParts, kParts - kLeastParts);
  Vec3 steps;
  for (std::size_t k = 0; k < 3; ++k) {
    steps[static_cast<Eigen::Index>(k)] = a[k] + n * (b[k] - a[k]) / kParts;
  }
  return grid.origin() + grid.step() * steps;
}

/// Returns the two triangles of a quadrangle, cut along its shorter diagonal; corners are positions
/// in the polygon.
std::array<std::array<std::size_t, 3>, 2> halves(const std::array<Vec3, 4>& corners) {
  if ((corners[0] - corners[2]).squaredNorm() <= (corners[1] - corners[3]).squaredNorm()) {
    return {{{0, 1, 2}, {0, 2, 3}}};
  }
  return {{{0, 1, 3}, {1, 2, 3}}};
}

}  // namespace

GridLabels label_vertices(const BisectionGrid& grid, const std::vector<Index>& leaves,
                          const Region& region, const GridLabels& known) {
  GridLabels labels;
  labels.vertices.resize(4 * leaves.size());
  for (std::size_t i = 0; i < labels.vertices.size(); ++i) {
    labels.vertices[i] = packed(grid.tetrahedron(leaves[i / 4]).corners[i % 4]);
  }
  sort_unique(labels.vertices);
  labels.inside.resize(labels.vertices.size());
  constexpr std::size_t kQuestions = 256;
  parallel_chunks(labels.vertices.size(), kQuestions, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const std::uint64_t key = labels.vertices[i];
      const std::size_t before = place_in(known.vertices, key);
      if (before < known.vertices.size() && known.vertices[before] == key) {
        labels.inside[i] = known.inside[before];
      } else {
        const LatticePoint p = unpacked(key);
        labels.inside[i] = !is_on_cube(p) && region.contains(grid.place(p)) ? 1 : 0;
      }
    }
  });
  return labels;
}

Contour march_tetrahedra(const BisectionGrid& grid, const std::vector<Index>& leaves,
                         const GridLabels& labels, const Region& region) {
  std::vector<LabelledTetrahedron> tetrahedra(leaves.size());
  parallel_chunks(leaves.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      tetrahedra[i] = labelled(grid.tetrahedron(leaves[i]), labels);
    }
  });
  std::vector<std::uint64_t> edges;
  for (const LabelledTetrahedron& t : tetrahedra) {
    if (!t.is_crossed()) continue;
    const auto polygon = t.polygon();
    for (std::size_t k = 0; k < t.n_corners(); ++k) edges.push_back(polygon[k].key());
  }
  sort_unique(edges);

  Contour contour;
  contour.positions.resize(edges.size());
  constexpr std::size_t kQuestions = 256;
  parallel_chunks(edges.size(), kQuestions, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const CrossedEdge edge{static_cast<Index>(edges[i] >> 32U), static_cast<Index>(edges[i])};
      contour.positions[i] = vertex_on(grid, labels, region, edge);
    }
  });
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    const LabelledTetrahedron& t = tetrahedra[i];
    if (!t.is_crossed()) continue;
    const auto polygon = t.polygon();
    std::array<Index, 4> v{};
    std::array<Vec3, 4> corners;
    for (std::size_t k = 0; k < t.n_corners(); ++k) {
      v[k] = static_cast<Index>(place_in(edges, polygon[k].key()));
      corners[k] = contour.positions[v[k]];
    }
    if (t.n_corners() == 3) {
      contour.triangles.push_back({v[0], v[1], v[2]});
      contour.leaves.push_back(leaves[i]);
      continue;
    }
    for (const auto& half : halves(corners)) {
      contour.triangles.push_back({v[half[0]], v[half[1]], v[half[2]]});
      contour.leaves.push_back(leaves[i]);
    }
  }
  return contour;
}

}  // namespace meshalyzer
