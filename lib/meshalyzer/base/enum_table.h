#pragma once

#include <array>
#include <cstddef>

namespace meshalyzer {

/// Tells whether the rows of a table stand in the order of an enumeration: row i is that of
/// enumerator i. A table for which this is asserted can be indexed by the enumerators.
///
/// @param key  The member of a row that says whose row it is.
template <typename Row, std::size_t n, typename Enum>
[[nodiscard]] constexpr bool is_in_enum_order(const std::array<Row, n>& rows, Enum Row::*key) {
  for (std::size_t i = 0; i < n; ++i) {
    if (rows[i].*key != static_cast<Enum>(i)) return false;
  }
  return true;
}

}  // namespace meshalyzer
