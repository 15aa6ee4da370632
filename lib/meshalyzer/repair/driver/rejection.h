#pragma once

#include <cstdint>
#include <string_view>

namespace meshalyzer {

/// Why an operation is rejected, or not even proposed.
enum class Rejection : std::uint8_t {
  None,
  /// The surface would deviate from the input by more than the maximum.
  TooFar,
  /// Faces would intersect that did not intersect before, and no other faces of the operation did
  /// instead of them.
  Intersects,
  /// It would create more defective elements of a kind than it removes.
  MoreDefects,
  /// It was tried, and after all passes the mesh was worse for it.
  EndsWorse,
};

/// Returns the sentence for logs: "undone: it would ...".
[[nodiscard]] std::string_view rejection_reason(Rejection rejection);

}  // namespace meshalyzer
