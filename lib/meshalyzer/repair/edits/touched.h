#pragma once

#include "meshalyzer/repair/edits/draft.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/skipped_operations.h"

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {

/// An element, by key, that an operation touches.
struct Touch {
  Index key = kNoIndex;
  Index operation = kNoIndex;
  friend auto operator<=>(const Touch&, const Touch&) = default;
};

/// What a list of edits touches, by key; each list ascending.
struct Touched {
  /// Faces that are removed or changed, or have a moved vertex: of the draft before.
  std::vector<Touch> faces_before;
  /// Faces that are changed or added, or have a moved vertex: of the draft after.
  std::vector<Touch> faces_after;
  /// Corners of all these, before and after.
  std::vector<Touch> vertices;
};

/// @param after  What apply_edits() made of it.
/// @complexity   O(#F + edits log edits).
[[nodiscard]] Touched find_touched(const Draft& before, const Edits& edits,
                                   const SkippedOperations& skipped, const Draft& after);

/// The operations that touch an element.
[[nodiscard]] std::span<const Touch> touching(const std::vector<Touch>& touches, Index key);

}  // namespace meshalyzer
