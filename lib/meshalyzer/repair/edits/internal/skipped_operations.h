#pragma once

#include "meshalyzer/base/types.h"

#include <cstdint>
#include <span>

namespace meshalyzer {

/// Tells which operations of a list of edits are not to be applied. This refers to a list and does
/// not own it.
class SkippedOperations {
 public:
  /// @param skipped  #operations, non-zero for skipped ones; if empty, none is skipped.
  explicit SkippedOperations(std::span<const std::uint8_t> skipped) : skipped_(skipped) {}

  [[nodiscard]] bool operator()(Index operation) const {
    return !skipped_.empty() && skipped_[operation] != 0;
  }

 private:
  std::span<const std::uint8_t> skipped_;
};

}  // namespace meshalyzer
