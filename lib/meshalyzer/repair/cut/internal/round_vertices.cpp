#include "meshalyzer/repair/cut/internal/round_vertices.h"

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/sort_unique.h"

#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace meshalyzer {
namespace {

/// So many bits of the largest coordinate are kept, round by round; the last number holds for all
/// rounds after.
constexpr std::array kBits{53, 53, 53, 40, 36, 32, 30, 28, 26, 24, 22, 20};

struct PositionHash {
  std::size_t operator()(const Vec3& position) const { return hash_position(position); }
};

/// Returns the distance of the places that coordinates are rounded to; 0 where the doubles nearest
/// to them will do.
double grid_of(const Arrangement& arrangement, std::size_t round) {
  const int bits = kBits[std::min(round, kBits.size() - 1)];
  if (bits >= 53) return 0.0;
  double largest = 0.0;
  for (std::size_t v = arrangement.n_input_vertices; v < arrangement.positions.size(); ++v) {
    largest = std::max(largest, arrangement.positions[v].cwiseAbs().maxCoeff());
  }
  return std::ldexp(1.0, std::ilogb(std::max(largest, 0x1p-900)) + 1 - bits);
}

/// The vertices of the pieces of cut faces. Ascending.
std::vector<Index> vertices_of_cut_faces(const Arrangement& arrangement) {
  std::vector<Index> vertices;
  for (const Index face : arrangement.cut_faces) {
    for (const Index piece : arrangement.pieces_of(face)) {
      const Triangle& t = arrangement.pieces[piece];
      vertices.insert(vertices.end(), t.begin(), t.end());
    }
  }
  sort_unique(vertices);
  return vertices;
}

}  // namespace

RoundedVertices round_vertices(const Arrangement& arrangement, std::size_t round) {
  RoundedVertices result;
  result.positions = arrangement.positions;
  const double grid = grid_of(arrangement, round);
  for (std::size_t v = arrangement.n_input_vertices; v < result.positions.size(); ++v) {
    if (grid == 0.0) break;
    for (double& x : result.positions[v]) x = std::nearbyint(x / grid) * grid;
  }
  result.stands_for.resize(result.positions.size());
  std::iota(result.stands_for.begin(), result.stands_for.end(), Index{0});
  std::unordered_map<Vec3, Index, PositionHash> at;
  for (const Index v : vertices_of_cut_faces(arrangement)) {
    result.stands_for[v] = at.emplace(result.positions[v], v).first->second;
  }
  return result;
}

}  // namespace meshalyzer
