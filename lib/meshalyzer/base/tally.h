#pragma once

#include "meshalyzer/base/types.h"

#include <atomic>
#include <type_traits>
#include <utility>

namespace meshalyzer {

/// Counts how often numbers occur, while other threads add to the same counts. Occurrences of one
/// number that follow each other are added at once, so that threads rarely write to the same place.
template <typename CountOf>
class Tally {
 public:
  /// @param count_of  Returns a reference to the count of a number.
  explicit Tally(CountOf count_of) : count_of_(std::move(count_of)) {}
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;
  ~Tally() { flush(); }

  void add(Index number) {
    if (number != number_) flush();
    number_ = number;
    ++n_;
  }

 private:
  using Count = std::remove_reference_t<std::invoke_result_t<CountOf&, Index>>;

  void flush() {
    if (n_ != 0) {
      std::atomic_ref<Count>(count_of_(number_)).fetch_add(n_, std::memory_order_relaxed);
    }
    n_ = 0;
  }

  CountOf count_of_;
  Index number_ = kNoIndex;
  Count n_ = 0;
};

}  // namespace meshalyzer
