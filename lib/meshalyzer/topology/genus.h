#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace meshalyzer {

/// The counts in the Euler-Poincaré formula.
struct EulerCounts {
  /// Vertices that faces use.
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t boundaries = 0;
};

/// Returns the genus of one component: the number of its handles, by V - E + F = 2 - 2 genus -
/// boundaries.
///
/// It means handles only where the component is manifold and orientable; that is for the caller to
/// know. The sum over several components is not what the formula gives for their total counts.
///
/// @return Nothing where no whole number >= 0 satisfies the formula.
[[nodiscard]] std::optional<std::int64_t> genus(const EulerCounts& counts);

}  // namespace meshalyzer
