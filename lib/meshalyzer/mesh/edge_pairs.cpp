#include "meshalyzer/mesh/edge_pairs.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// A side as one key: its larger vertex (31 bits), its corner (32 bits), and whether it starts at
/// the larger vertex. Sorting the keys in the bucket of a smaller vertex groups them by edge, in
/// order of their faces.
using SideKey = std::uint64_t;

constexpr SideKey side_key(Index larger, Index corner, SideKey direction) {
  return (SideKey{larger} << 33U) | (SideKey{corner} << 1U) | direction;
}
constexpr Index corner_of(SideKey key) {
  return static_cast<Index>(key >> 1U);
}
constexpr bool same_edge(SideKey a, SideKey b) {
  return ((a ^ b) >> 33U) == 0;
}
constexpr bool same_direction(SideKey a, SideKey b) {
  return ((a ^ b) & 1U) == 0;
}

/// The sides of a complex in buckets, one for each smaller vertex.
struct SideBuckets {
  /// Bucket v is [begin[v], begin[v + 1]).
  std::vector<Index> begin;
  /// #corners keys. A std::vector would initialise them before they are filled.
  std::unique_ptr<SideKey[]> keys;

  [[nodiscard]] std::span<SideKey> operator[](std::size_t v) const {
    return {keys.get() + begin[v], keys.get() + begin[v + 1]};
  }
};

SideBuckets bucket_sides(const Complex& complex) {
  SideBuckets buckets;
  // The counts stand two places up, so that filling the buckets moves every begin into its place.
  std::vector<Index>& begin = buckets.begin;
  begin.assign(complex.n_vertices + 2, 0);
  for (std::size_t face = 0; face < complex.faces.size(); ++face) {
    const Triangle& t = complex.triangle(face);
    ++begin[std::min(t[0], t[1]) + std::size_t{2}];
    ++begin[std::min(t[1], t[2]) + std::size_t{2}];
    ++begin[std::min(t[2], t[0]) + std::size_t{2}];
  }
  for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];

  buckets.keys = std::make_unique_for_overwrite<SideKey[]>(complex.n_corners());
  const auto put = [&](Index from, Index to, Index corner) {
    const Index smaller = std::min(from, to);
    const Index larger = std::max(from, to);
    buckets.keys[begin[smaller + std::size_t{1}]++] = side_key(larger, corner, from > to ? 1 : 0);
  };
  Index corner = 0;
  for (std::size_t face = 0; face < complex.faces.size(); ++face) {
    const Triangle& t = complex.triangle(face);
    put(t[0], t[1], corner++);
    put(t[1], t[2], corner++);
    put(t[2], t[0], corner++);
  }
  return buckets;
}

/// Most buckets hold half a dozen keys, for which insertion sort is fastest.
void sort_bucket(std::span<SideKey> keys) {
  constexpr std::size_t kFew = 24;
  if (keys.size() > kFew) {
    std::sort(keys.begin(), keys.end());
    return;
  }
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const SideKey key = keys[i];
    std::size_t hole = i;
    for (; hole > 0 && keys[hole - 1] > key; --hole) keys[hole] = keys[hole - 1];
    keys[hole] = key;
  }
}

/// The cut edges that one chunk of buckets finds.
struct ChunkPairs {
  std::size_t n_pairs = 0;
  CornerLists non_manifold;
  CornerLists flipped;
};

/// Joins or cuts the edges of one sorted bucket.
void pair_bucket(std::span<const SideKey> keys, std::span<Index> opposite, ChunkPairs& found) {
  const auto cut = [](CornerLists& lists, std::span<const SideKey> edge) {
    for (const SideKey key : edge) lists.push_back(corner_of(key));
    lists.end_list();
  };
  for (std::size_t first = 0, last = 0; first < keys.size(); first = last) {
    do ++last;
    while (last < keys.size() && same_edge(keys[first], keys[last]));
    const auto edge = keys.subspan(first, last - first);
    if (edge.size() > 2) {
      cut(found.non_manifold, edge);
    } else if (edge.size() == 2 && same_direction(edge[0], edge[1])) {
      cut(found.flipped, edge);
    } else if (edge.size() == 2) {
      opposite[corner_of(edge[0])] = corner_of(edge[1]);
      opposite[corner_of(edge[1])] = corner_of(edge[0]);
      ++found.n_pairs;
    }
  }
}

}  // namespace

EdgePairs pair_edges(const Complex& complex) {
  const SideBuckets buckets = bucket_sides(complex);
  EdgePairs pairs;
  pairs.opposite.assign(complex.n_corners(), kNoIndex);
  const auto found = map_chunks<ChunkPairs>(complex.n_vertices, [&](Chunk chunk) {
    ChunkPairs result;
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      const std::span<SideKey> bucket = buckets[v];
      sort_bucket(bucket);
      pair_bucket(bucket, pairs.opposite, result);
    }
    return result;
  });
  for (const ChunkPairs& chunk : found) {
    pairs.n_pairs += chunk.n_pairs;
    pairs.non_manifold.append(chunk.non_manifold);
    pairs.flipped.append(chunk.flipped);
  }
  return pairs;
}

}  // namespace meshalyzer
