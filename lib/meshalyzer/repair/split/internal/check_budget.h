#pragma once

#include <algorithm>
#include <cstddef>

namespace meshalyzer {

// Private to part_contacts().

/// The number of pairs of faces that may be checked to part the faces at some places, so that heaps
/// of faces, which cannot be parted, do not take for ever.
class CheckBudget {
 public:
  explicit CheckBudget(std::size_t n_moves) : n_left_(kMore + kMeanAMove * n_moves) {}

  /// Returns the maximum number of pairs for the next place.
  [[nodiscard]] std::size_t of_next_place() const {
    return std::min(n_left_, kMostAPlace + n_more_left_);
  }

  /// Takes away the number of pairs that were checked at a place.
  void spend(std::size_t n_checks) {
    n_left_ -= std::min(n_left_, n_checks);
    if (n_checks > kMostAPlace) n_more_left_ -= std::min(n_more_left_, n_checks - kMostAPlace);
  }

 private:
  /// Most places need some hundreds, one in ten thousand more than these.
  static constexpr std::size_t kMostAPlace = 8'192;
  /// The number that those few places have in addition, all together.
  static constexpr std::size_t kMore = 300'000;
  /// The mean of all moves besides. Where faces can be parted, hundreds of moves need a hundred
  /// each.
  static constexpr std::size_t kMeanAMove = 512;

  std::size_t n_left_;
  std::size_t n_more_left_ = kMore;
};

}  // namespace meshalyzer
