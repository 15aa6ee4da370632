#pragma once

#include <cmath>
#include <concepts>

namespace meshalyzer {

// Private to weld_borders().

/// Halves a reach until it fits, and returns it. The number of halvings is searched by bisection,
/// because a mesh with a vertex at 1e35 needs more than a hundred.
///
/// @param reach  A finite length.
/// @param fits   Tells whether a reach fits; if one does, shorter ones do too. The least reach
/// above 0 is returned even if it does not. Of the calls that return true, the last one is for the
/// result.
/// @complexity   O(log n) calls of `fits` for n halvings.
template <std::predicate<double> Fits>
[[nodiscard]] double halve_until(double reach, const Fits& fits) {
  const auto halved = [&](int times) { return std::ldexp(reach, -times); };
  const auto is_enough = [&](int times) { return halved(times + 1) == 0.0 || fits(halved(times)); };
  int too_few = -1;
  int enough = 0;
  for (; !is_enough(enough); enough = 2 * enough + 1) too_few = enough;
  while (enough - too_few > 1) {
    const int middle = too_few + (enough - too_few) / 2;
    (is_enough(middle) ? enough : too_few) = middle;
  }
  return halved(enough);
}

}  // namespace meshalyzer
