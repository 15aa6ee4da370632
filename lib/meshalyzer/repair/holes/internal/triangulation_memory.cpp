#include "meshalyzer/repair/holes/internal/triangulation_memory.h"

#include "meshalyzer/base/hash.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/repair/holes/internal/corner_numbers.h"
#include "meshalyzer/repair/holes/internal/triangulate_loop.h"

#include <bit>
#include <utility>

namespace meshalyzer {
namespace {

/// Shorter loops are triangulated sooner than recalled.
constexpr std::size_t kLeastCorners = 24;
/// Nothing more is noted once so many triangles are, which take 12 bytes each.
constexpr std::size_t kMostTriangles = 4'000'000;

std::uint64_t hash_triangle(const Triangle& corners) {
  const Triangle t = sorted_corners(corners);
  return mix_hash(mix_hash(t[0], t[1]), t[2]);
}

/// Hashes all that a triangulation depends on, but for the numbers of the vertices.
std::uint64_t hash_of(const LoopPolygon& polygon, const LoopRules& rules,
                      const CornerNumbers& corners) {
  std::uint64_t hash = mix_hash(polygon.size(), static_cast<std::uint64_t>(rules.weight));
  hash = mix_hash(hash, std::bit_cast<std::uint64_t>(polygon.thin));
  for (Index i = 0; i < polygon.size(); ++i) {
    hash = mix_hash(hash, hash_position(polygon.points[i]));
    hash = mix_hash(hash, hash_position(polygon.normals[i]));
    hash = mix_hash(hash, corners.of(polygon.vertices[i]));
    for (Index k = 0; k < i; ++k) {
      if (!rules.allows_chord(polygon.vertices[k], polygon.vertices[i])) hash = mix_hash(hash, k);
    }
  }
  // The order of the forbidden triangles depends on the numbers of the vertices.
  std::uint64_t sum = 0;
  for (const Triangle& forbidden : rules.forbidden) {
    const Triangle t = corners.of(forbidden);
    if (has_all_corners(t)) sum += hash_triangle(t);
  }
  return mix_hash(hash, sum);
}

}  // namespace

std::optional<std::vector<Triangle>> TriangulationMemory::triangulate(const LoopPolygon& polygon,
                                                                      const LoopRules& rules) {
  if (polygon.size() < kLeastCorners) return triangulate_loop(polygon, rules);
  const CornerNumbers corners(polygon.vertices);
  const std::uint64_t hash = hash_of(polygon, rules, corners);
  if (const Triangles* known = find_known(hash)) {
    if (!*known) return std::nullopt;
    return at_vertices(**known, polygon.vertices);
  }
  Triangles triangles = triangulate_loop(polygon, rules);
  note(hash, triangles ? Triangles(corners.of(*triangles)) : std::nullopt);
  return triangles;
}

std::size_t TriangulationMemory::n_known() const {
  const std::lock_guard lock(mutex_);
  return known_.size();
}

const TriangulationMemory::Triangles* TriangulationMemory::find_known(std::uint64_t hash) const {
  const std::lock_guard lock(mutex_);
  const auto found = known_.find(hash);
  return found == known_.end() ? nullptr : &found->second;
}

void TriangulationMemory::note(std::uint64_t hash, Triangles triangles) {
  const std::lock_guard lock(mutex_);
  if (n_triangles_ >= kMostTriangles) return;
  n_triangles_ += triangles ? triangles->size() : 1;
  known_.emplace(hash, std::move(triangles));
}

}  // namespace meshalyzer
