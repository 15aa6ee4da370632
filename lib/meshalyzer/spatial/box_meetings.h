#pragma once

#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/slab_tree.h"

#include <functional>
#include <memory>
#include <vector>

namespace meshalyzer {

/// Finds the pairs of faces of two trees, one face of each, whose boxes meet.
///
/// The leaves of the outer tree that are near the inner tree descend the inner one. The tree with
/// fewer such leaves is the outer one. Bundles of slivers are an exception: if a sample of the
/// leaves meets far too many faces, and one of the trees has slabs to separate them (see SlabTree),
/// that tree is the inner one.
class BoxMeetings {
 public:
  enum class Next { GoOn, Stop };
  /// Receives the number of a chunk, a slot of the first tree and one of the second.
  using Meet = std::function<Next(std::size_t chunk, std::size_t a, std::size_t b)>;

  BoxMeetings(const FaceTree& a, const FaceTree& b);

  /// Returns the number of chunks. Results that are kept per chunk and combined in chunk order are
  /// the same for any number of threads.
  [[nodiscard]] std::size_t n_chunks() const;

  /// Calls `meet` for all pairs, chunks in parallel; Next::Stop ends the whole search.
  ///
  /// @return      Next::Stop if the search was stopped.
  /// @complexity  O(n log #F + pairs) for the n leaves of the outer tree that are near the inner.
  Next run(const Meet& meet) const;

 private:
  [[nodiscard]] bool is_laborious() const;
  void make_slabs();
  /// @param leaves  The leaves of the inner tree that are near the outer one.
  void swap_roles(std::vector<Index> leaves);

  const FaceTree* outer_;
  const FaceTree* inner_;
  bool is_swapped_ = false;
  /// The leaves of the outer tree whose boxes meet the box of the whole inner tree.
  std::vector<Index> leaves_;
  /// The slabs of the inner tree, or null if they are not needed.
  std::unique_ptr<const SlabTree> slabs_;
};

}  // namespace meshalyzer
