#pragma once

#include <cstdint>
#include <string_view>

namespace meshalyzer {

/// The reasons why an operation is rejected, or not even proposed.
enum class Rejection : std::uint8_t {
  None,
  /// The surface would deviate from the input by more than the maximum deviation.
  TooFar,
  /// Faces would intersect that did not intersect before, and that did not inherit the contact from
  /// other faces of the operation.
  Intersects,
  /// It would create more defective elements of a kind than it removes.
  MoreDefects,
  /// It would leave as many intersecting pairs and border edges as there were.
  MendsNothing,
  /// It was tried, and the mesh was worse for it after all passes.
  EndsWorse,
};

/// Returns the sentence for logs: "undone: it would ...".
[[nodiscard]] std::string_view rejection_reason(Rejection rejection);

}  // namespace meshalyzer
