#pragma once

#include "meshalyzer/arrangement/point_name.h"

#include <cstddef>
#include <span>

namespace meshalyzer {

/// Returns how much memory the digits of exact points take on the heap, before they are
/// constructed.
///
/// The coordinates of a point are quotients of polynomials in those of the vertices in its name, of
/// a degree of up to seven. So they have up to seven times as many binary digits as there are
/// between the first digit of the largest and the last of the smallest of these: some hundred in
/// most meshes, thousands if some coordinates are 1e150 and others 1.
///
/// @param names  Each counts.
/// @return       An upper bound in bytes; 0 for numbers that are so short that they are on no heap.
/// @complexity   O(#V + #names)
[[nodiscard]] std::size_t most_digit_bytes(const Soup& soup, std::span<const PointName> names);

}  // namespace meshalyzer
