#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace meshalyzer {

/// The counts in the Euler-Poincaré formula.
struct EulerCounts {
  /// The number of vertices that faces use.
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t boundaries = 0;
};

/// Returns the genus of one component, the number of its handles, by V - E + F = 2 - 2 genus -
/// boundaries.
///
/// It is the number of handles only when the component is manifold and orientable, which the caller
/// must know. The formula does not hold for the total counts of several components.
///
/// @return Nothing when no whole number >= 0 satisfies the formula.
[[nodiscard]] std::optional<std::int64_t> genus(const EulerCounts& counts);

}  // namespace meshalyzer
