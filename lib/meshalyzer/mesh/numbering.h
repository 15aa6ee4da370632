#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <optional>

namespace meshalyzer {

/// Finds where the ids of `n` records of a file cease to be 1, 2, ..., n. Only a file that names
/// its ids, a `.mesh` file, can have such a place.
///
/// @return     The first record whose id is not its number.
/// @complexity O(n).
[[nodiscard]] std::optional<Index> first_misnumbered(const Ids& ids, Format format, std::size_t n);

}  // namespace meshalyzer
