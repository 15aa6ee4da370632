#pragma once

#include <cstddef>

namespace meshalyzer {

/// The number of children of a node in the implicit trees over boxes and triangles.
inline constexpr std::size_t kTreeWidth = 8;

}  // namespace meshalyzer
