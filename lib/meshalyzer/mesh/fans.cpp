#include "meshalyzer/mesh/fans.h"

#include "meshalyzer/base/atomic_min.h"
#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

/// Calls `visit` with every corner of the fan that holds `start`, each once, `start` first.
template <typename Visit>
void walk_fan(std::span<const Index> opposite, Index start, Visit&& visit) {
  Index corner = start;
  do {
    visit(corner);
    corner = opposite[previous_corner(corner)];
    if (corner == start) return;
  } while (corner != kNoIndex);
  // The fan is open: the rest of it lies on the other side of the start.
  for (Index side = opposite[start]; side != kNoIndex; side = opposite[corner]) {
    corner = next_corner(side);
    visit(corner);
  }
}

/// Returns the lowest corner at each vertex, kNoIndex where there is none.
std::vector<Index> find_first_corners(const Complex& complex) {
  std::vector<Index> first(complex.n_vertices, kNoIndex);
  parallel_chunks(complex.faces.size(), [&](Chunk faces) {
    auto corner = static_cast<Index>(3 * faces.begin);
    for (std::size_t face = faces.begin; face < faces.end; ++face) {
      for (const Index v : complex.triangle(face)) atomic_min(first[v], corner++);
    }
  });
  return first;
}

/// Returns the vertices that have corners outside the fan of their first one, ascending.
std::vector<Index> find_split_vertices(const Complex& complex, const EdgePairs& pairs,
                                       std::span<const Index> first_corner) {
  std::vector<Index> n_unseen(complex.n_vertices, 0);
  const auto n_seen = map_chunks<std::size_t>(complex.n_vertices, [&](Chunk chunk) {
    std::size_t sum = 0;
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      Index n = 0;
      if (first_corner[v] != kNoIndex) {
        walk_fan(pairs.opposite, first_corner[v], [&](Index) { ++n; });
      }
      n_unseen[v] = n;
      sum += n;
    }
    return sum;
  });
  std::vector<Index> split;
  if (std::accumulate(n_seen.begin(), n_seen.end(), std::size_t{0}) == complex.n_corners()) {
    return split;
  }
  for (std::size_t face = 0; face < complex.faces.size(); ++face) {
    for (const Index v : complex.triangle(face)) --n_unseen[v];
  }
  for (Index v = 0; v < complex.n_vertices; ++v) {
    if (n_unseen[v] != 0) split.push_back(v);
  }
  return split;
}

/// Returns the corners at each of the given vertices (ascending), one ascending list for each
/// vertex.
CornerLists collect_corners(const Complex& complex, std::span<const Index> vertices) {
  // The end of each vertex's list while it is filled. The counts stand two lists up, so that
  // filling moves every begin into its place.
  std::vector<Index> list_of(complex.n_vertices, kNoIndex);
  for (Index i = 0; i < vertices.size(); ++i) list_of[vertices[i]] = i;
  CornerLists lists;
  lists.begin.assign(vertices.size() + 2, 0);
  const auto n_corners = static_cast<Index>(complex.n_corners());
  for (Index corner = 0; corner < n_corners; ++corner) {
    const Index list = list_of[complex.vertex(corner)];
    if (list != kNoIndex) ++lists.begin[list + std::size_t{2}];
  }
  std::partial_sum(lists.begin.begin(), lists.begin.end(), lists.begin.begin());
  lists.corners.resize(lists.begin.back());
  for (Index corner = 0; corner < n_corners; ++corner) {
    const Index list = list_of[complex.vertex(corner)];
    if (list != kNoIndex) lists.corners[lists.begin[list + std::size_t{1}]++] = corner;
  }
  lists.begin.pop_back();
  return lists;
}

/// The fans at the vertices that have several.
class SplitVertices {
 public:
  SplitVertices(const Complex& complex, const EdgePairs& pairs, std::vector<Index> vertices)
      : complex_(complex),
        vertices_(std::move(vertices)),
        corners_(collect_corners(complex, vertices_)),
        fan_of_(corners_.corners.size(), kNoIndex) {
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      n_joined_fans_.push_back(find_fans_of(i, pairs.opposite));
    }
    joined_fans_ = DisjointSets(n_fans_);
  }

  /// The further fans: all but the first of each vertex.
  [[nodiscard]] const std::vector<Index>& copies() const { return copies_; }
  [[nodiscard]] const CornerLists& copied_corners() const { return copied_corners_; }

  /// Joins the fans on the two sides of an edge, only for non_manifold_vertices().
  void join_across(Index side, Index other_side) {
    join_at(side, other_side);
    join_at(next_corner(side), next_corner(other_side));
  }

  /// Returns the vertices that still have more than one fan, ascending.
  [[nodiscard]] std::vector<Index> non_manifold_vertices() const {
    std::vector<Index> result;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (n_joined_fans_[i] > 1) result.push_back(vertices_[i]);
    }
    return result;
  }

 private:
  /// Numbers the fans of vertex i of the list, stores all except the first, and returns their
  /// number.
  Index find_fans_of(std::size_t i, std::span<const Index> opposite) {
    const Index n_before = n_fans_;
    for (std::size_t place = corners_.begin[i]; place < corners_.begin[i + 1]; ++place) {
      if (fan_of_[place] != kNoIndex) continue;
      const bool is_copy = n_fans_ > n_before;
      walk_fan(opposite, corners_.corners[place], [&](Index corner) {
        fan_of_[place_of(i, corner)] = n_fans_;
        if (is_copy) copied_corners_.push_back(corner);
      });
      if (is_copy) {
        copied_corners_.end_list();
        copies_.push_back(vertices_[i]);
      }
      ++n_fans_;
    }
    return n_fans_ - n_before;
  }

  /// Returns the index in `corners_` of a corner at vertex i of the list.
  [[nodiscard]] std::size_t place_of(std::size_t i, Index corner) const {
    const auto list = corners_[i];
    const auto found = std::lower_bound(list.begin(), list.end(), corner);
    return corners_.begin[i] + static_cast<std::size_t>(found - list.begin());
  }

  /// Joins the fans of two corners at the same vertex.
  void join_at(Index corner, Index other_corner) {
    const Index v = complex_.vertex(corner);
    const auto found = std::lower_bound(vertices_.begin(), vertices_.end(), v);
    if (found == vertices_.end() || *found != v) return;
    const auto i = static_cast<std::size_t>(found - vertices_.begin());
    const Index a = fan_of_[place_of(i, corner)];
    const Index b = fan_of_[place_of(i, other_corner)];
    if (joined_fans_.find(a) == joined_fans_.find(b)) return;
    joined_fans_.unite(a, b);
    --n_joined_fans_[i];
  }

  const Complex& complex_;
  std::vector<Index> vertices_;
  CornerLists corners_;
  /// The fan of each corner in `corners_`.
  std::vector<Index> fan_of_;
  Index n_fans_ = 0;
  /// The number of fans at each vertex; fans that join_across() joined count as one.
  std::vector<Index> n_joined_fans_;
  DisjointSets joined_fans_{0};
  std::vector<Index> copies_;
  CornerLists copied_corners_;
};

/// Returns the vertices whose faces are not one fan when flipped edges join them too.
///
/// The ends of non-manifold edges are among them: three or more sides end at such an edge, and a
/// fan has but two ends.
std::vector<Index> find_non_manifold_vertices(const EdgePairs& pairs, SplitVertices& split) {
  for (std::size_t i = 0; i < pairs.flipped.size(); ++i) {
    // Both sides run in the same direction, so their first corners are at the same vertex.
    split.join_across(pairs.flipped[i][0], pairs.flipped[i][1]);
  }
  return split.non_manifold_vertices();
}

}  // namespace

Fans find_fans(const Complex& complex, const EdgePairs& pairs) {
  Fans fans;
  fans.first_corner = find_first_corners(complex);
  SplitVertices split(complex, pairs, find_split_vertices(complex, pairs, fans.first_corner));
  fans.copies = split.copies();
  fans.copied_corners = split.copied_corners();
  for (std::size_t i = 0; i < fans.copies.size(); ++i) {
    fans.first_corner.push_back(fans.copied_corners[i].front());
  }
  fans.non_manifold_vertices = find_non_manifold_vertices(pairs, split);
  return fans;
}

}  // namespace meshalyzer
