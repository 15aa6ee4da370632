#pragma once

#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/slab_tree.h"

#include <functional>
#include <memory>
#include <vector>

namespace meshalyzer {

/// Finds the pairs of faces, one of each of two trees, whose boxes meet.
///
/// The leaves of one tree, the outer, that are near the other, the inner, are taken down the inner
/// one. The tree that has fewer of them is the outer, but for bundles of slivers: where a sample of
/// the leaves meets far too many faces, and one of the trees has slabs to tell them apart (see
/// SlabTree), that one is the inner.
class BoxMeetings {
 public:
  enum class Next { GoOn, Stop };
  /// Called with the number of a chunk, a slot of the first tree and one of the second.
  using Meet = std::function<Next(std::size_t chunk, std::size_t a, std::size_t b)>;

  BoxMeetings(const FaceTree& a, const FaceTree& b);

  /// Returns the number of chunks. Results that are kept per chunk and combined in chunk order are
  /// the same for any number of threads.
  [[nodiscard]] std::size_t n_chunks() const;

  /// Calls `meet` for all pairs, chunks in parallel; Next::Stop ends the whole search.
  ///
  /// @return      Whether it was stopped.
  /// @complexity  O(n log #F + pairs) for the n leaves of the outer tree that are near the inner.
  Next run(const Meet& meet) const;

 private:
  [[nodiscard]] bool is_laborious() const;
  void make_slabs();
  /// @param leaves  Those of the inner tree that are near the outer.
  void swap_roles(std::vector<Index> leaves);

  const FaceTree* outer_;
  const FaceTree* inner_;
  bool is_swapped_ = false;
  /// The leaves of the outer tree whose boxes meet the box of the whole inner tree.
  std::vector<Index> leaves_;
  /// The slabs of the inner tree; null where they are not needed.
  std::unique_ptr<const SlabTree> slabs_;
};

}  // namespace meshalyzer
