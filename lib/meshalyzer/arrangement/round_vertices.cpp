#include "meshalyzer/arrangement/round_vertices.h"

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/parallel_sort.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace meshalyzer {
namespace {

/// The resolution of the grid of each round, see grid_spacing(). The first rounds use the nearest
/// doubles; later ones round the new points, and the last ones all vertices of intersecting faces.
constexpr std::array<int, kRoundingRounds> kGridBits{0,  0,  24, 24, 24, 24, 24,
                                                     24, 20, 20, 20, 17, 17, 17};
constexpr std::size_t kFirstSnappedRound = 2;
constexpr std::size_t kFirstRoundOfAll = 3;
/// Rounding moves vertices no farther than about this share of the maximum deviation.
constexpr double kRoundingShare = 0.25;

struct PositionHash {
  std::size_t operator()(const Vec3& position) const { return hash_position(position); }
};

using VertexAt = std::unordered_map<Vec3, Index, PositionHash>;

/// Returns the vertices of the pieces of cut faces, ascending.
std::vector<Index> vertices_of_cut_faces(const Arrangement& arrangement) {
  std::vector<Index> vertices;
  for (const Index face : arrangement.cut_faces) {
    for (const Index piece : arrangement.pieces_of(face)) {
      const Triangle& t = arrangement.pieces[piece];
      vertices.insert(vertices.end(), t.begin(), t.end());
    }
  }
  parallel_sort_unique(vertices);
  return vertices;
}

/// Rounds vertices to the points of a grid near vertices of cut faces.
void snap(const std::vector<Index>& of_cut_faces, const Rounding& rounding,
          RoundedVertices& rounded) {
  VertexAt at;
  for (const Index v : of_cut_faces) {
    if (v < rounding.first_to_snap) continue;
    at.emplace(nearest_on_grid(rounded.positions[v], rounding.spacing), kNoIndex);
  }
  const std::size_t n_vertices = rounded.stands_for.size();
  // A vertex that is already on the grid keeps its position.
  for (std::size_t v = n_vertices; v-- > 0;) {
    const auto found = at.find(rounded.positions[v]);
    if (found != at.end()) found->second = static_cast<Index>(v);
  }
  for (std::size_t v = rounding.first_to_snap; v < n_vertices; ++v) {
    const auto found = at.find(nearest_on_grid(rounded.positions[v], rounding.spacing));
    if (found == at.end()) continue;
    if (found->second == kNoIndex) {
      found->second = static_cast<Index>(rounded.positions.size());
      rounded.positions.push_back(found->first);
    }
    rounded.stands_for[v] = found->second;
  }
}

/// Merges the vertices of cut faces that are at one place to the lowest.
void merge(const std::vector<Index>& of_cut_faces, RoundedVertices& rounded) {
  VertexAt at;
  for (const Index v : of_cut_faces) {
    Index& stands_for = rounded.stands_for[v];
    stands_for = at.emplace(rounded.positions[stands_for], stands_for).first->second;
  }
}

}  // namespace

Vec3 nearest_on_grid(const Vec3& position, double spacing) {
  return (position / spacing).array().rint().matrix() * spacing;
}

double grid_spacing(int bits, double extent, double max_deviation) {
  const double largest_move = kRoundingShare * max_deviation;
  if (!(extent > 0.0) || !(largest_move > 0.0)) return 0.0;
  return std::ldexp(1.0, std::min(std::ilogb(extent) + 1 - bits, std::ilogb(largest_move)));
}

Rounding rounding_of_round(std::size_t round, const RoundingLimits& limits) {
  if (round < kFirstSnappedRound) return {};
  return {.spacing = grid_spacing(kGridBits[round], limits.extent, limits.max_deviation),
          .first_to_snap = round < kFirstRoundOfAll ? limits.n_input_vertices : 0};
}

RoundedVertices round_vertices(const Arrangement& arrangement, const Rounding& rounding) {
  RoundedVertices rounded{.positions = arrangement.positions,
                          .stands_for = std::vector<Index>(arrangement.positions.size())};
  std::iota(rounded.stands_for.begin(), rounded.stands_for.end(), Index{0});
  const std::vector<Index> of_cut_faces = vertices_of_cut_faces(arrangement);
  if (rounding.spacing > 0.0) snap(of_cut_faces, rounding, rounded);
  merge(of_cut_faces, rounded);
  return rounded;
}

}  // namespace meshalyzer
