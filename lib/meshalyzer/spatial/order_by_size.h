#pragma once

#include "meshalyzer/base/corners.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Orders triangles by classes of size, the largest first, and within a class along a space-filling
/// curve: eight in a row are near each other, and one long triangle is not among small ones, whose
/// common box it would make large.
///
/// @param triangles  Triangles with coordinates of about -1 ... 1.
/// @return           #triangles: their numbers.
/// @complexity       O(n log n).
[[nodiscard]] std::vector<Index> order_by_size(std::span<const Corners> triangles);

}  // namespace meshalyzer
