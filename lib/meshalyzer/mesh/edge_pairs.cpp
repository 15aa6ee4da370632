#include "meshalyzer/mesh/edge_pairs.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <numeric>
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

/// A side with the vertex whose bucket it belongs in.
struct KeyedSide {
  Index smaller;
  SideKey key;
};

KeyedSide side_of(const Complex& complex, Index corner) {
  const Index from = complex.vertex(corner);
  const Index to = complex.vertex(next_corner(corner));
  return {std::min(from, to), side_key(std::max(from, to), corner, from > to ? 1 : 0)};
}

/// The sides of a complex, distributed to ranges of vertices by their smaller vertex, so that each
/// range can be paired by itself.
class SidesByRange {
 public:
  explicit SidesByRange(const Complex& complex)
      : range_length_(std::max(kMinRangeLength, std::bit_ceil(complex.n_vertices / kMaxRanges))),
        shift_(static_cast<unsigned>(std::countr_zero(range_length_))),
        begin_(n_chunks(complex.n_vertices, range_length_) + 1) {
    distribute(complex);
  }

  /// The number of vertices of each range but the last.
  [[nodiscard]] std::size_t range_length() const { return range_length_; }

  /// Returns the corners at which the sides of a range begin, ascending.
  [[nodiscard]] std::span<const Index> operator[](std::size_t range) const {
    return {corners_.get() + begin_[range], corners_.get() + begin_[range + 1]};
  }

 private:
  /// The keys of a range should stay in the cache, and the ranges be few enough to write to all of
  /// them at a time.
  static constexpr std::size_t kMinRangeLength = 4096;
  static constexpr std::size_t kMaxRanges = 256;

  /// Calls `visit(corner, range)` for all sides of a chunk of faces.
  template <typename Visit>
  void for_each_side(const Complex& complex, Chunk faces, Visit&& visit) const {
    auto corner = static_cast<Index>(3 * faces.begin);
    for (std::size_t face = faces.begin; face < faces.end; ++face) {
      const Triangle& t = complex.triangle(face);
      visit(corner++, std::min(t[0], t[1]) >> shift_);
      visit(corner++, std::min(t[1], t[2]) >> shift_);
      visit(corner++, std::min(t[2], t[0]) >> shift_);
    }
  }

  void distribute(const Complex& complex) {
    const std::size_t n_ranges = begin_.size() - 1;
    const std::size_t n_faces = complex.faces.size();
    // For each chunk of faces and each range first their number of sides, then the place of the
    // next one.
    std::vector<Index> places(n_chunks(n_faces) * n_ranges, 0);
    parallel_chunks(n_faces, [&](Chunk chunk) {
      Index* count = &places[chunk.number * n_ranges];
      for_each_side(complex, chunk, [&](Index, Index range) { ++count[range]; });
    });
    Index n = 0;
    for (std::size_t range = 0; range < n_ranges; ++range) {
      begin_[range] = n;
      for (std::size_t i = range; i < places.size(); i += n_ranges) {
        n += std::exchange(places[i], n);
      }
    }
    begin_[n_ranges] = n;
    corners_ = std::make_unique_for_overwrite<Index[]>(n);
    parallel_chunks(n_faces, [&](Chunk chunk) {
      Index* place = &places[chunk.number * n_ranges];
      for_each_side(complex, chunk,
                    [&](Index corner, Index range) { corners_[place[range]++] = corner; });
    });
  }

  std::size_t range_length_;
  unsigned shift_;
  /// Range r is [begin_[r], begin_[r + 1]).
  std::vector<Index> begin_;
  /// #corners. Here and below a std::vector would initialise what is then filled.
  std::unique_ptr<Index[]> corners_;
};

/// The sides of one range of vertices in buckets, one for each smaller vertex.
struct SideBuckets {
  /// Bucket i is [begin[i], begin[i + 1]).
  std::vector<Index> begin;
  std::unique_ptr<SideKey[]> keys;

  [[nodiscard]] std::span<SideKey> operator[](std::size_t i) const {
    return {keys.get() + begin[i], keys.get() + begin[i + 1]};
  }
};

/// @param vertices  The smaller vertices of the sides that begin at the given corners.
SideBuckets bucket_sides(const Complex& complex, Chunk vertices, std::span<const Index> corners) {
  const auto room = std::make_unique_for_overwrite<KeyedSide[]>(corners.size());
  const std::span<KeyedSide> sides(room.get(), corners.size());
  std::transform(corners.begin(), corners.end(), sides.begin(),
                 [&](Index corner) { return side_of(complex, corner); });
  // The counts stand two places up, so that filling the buckets moves every begin into its place.
  SideBuckets buckets{.begin = std::vector<Index>(vertices.end - vertices.begin + 2, 0),
                      .keys = std::make_unique_for_overwrite<SideKey[]>(sides.size())};
  for (const KeyedSide& side : sides) ++buckets.begin[side.smaller - vertices.begin + 2];
  std::partial_sum(buckets.begin.begin(), buckets.begin.end(), buckets.begin.begin());
  for (const KeyedSide& side : sides) {
    buckets.keys[buckets.begin[side.smaller - vertices.begin + 1]++] = side.key;
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

/// The cut edges of one range of vertices.
struct CutSides {
  CornerLists non_manifold;
  CornerLists flipped;
};

/// Joins or cuts the edges of one sorted bucket.
void pair_bucket(std::span<const SideKey> keys, std::span<Index> opposite, CutSides& found) {
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
    }
  }
}

}  // namespace

EdgePairs pair_edges(const Complex& complex) {
  const SidesByRange sides(complex);
  EdgePairs pairs;
  pairs.opposite.assign(complex.n_corners(), kNoIndex);
  std::vector<CutSides> found(n_chunks(complex.n_vertices, sides.range_length()));
  parallel_chunks(complex.n_vertices, sides.range_length(), [&](Chunk vertices) {
    const SideBuckets buckets = bucket_sides(complex, vertices, sides[vertices.number]);
    for (std::size_t i = 0; i < vertices.end - vertices.begin; ++i) {
      sort_bucket(buckets[i]);
      pair_bucket(buckets[i], pairs.opposite, found[vertices.number]);
    }
  });
  for (const CutSides& range : found) {
    pairs.non_manifold.append(range.non_manifold);
    pairs.flipped.append(range.flipped);
  }
  return pairs;
}

}  // namespace meshalyzer
