#pragma once

#include "meshalyzer/io/attributes.h"
#include "meshalyzer/mesh/soup.h"

#include <string_view>
#include <vector>

namespace meshalyzer {

/// Counts what a file says beside vertices and triangles.
///
/// @param soup   What was read from the bytes.
/// @complexity   O(bytes).
[[nodiscard]] std::vector<AttributeCount> count_attributes(const Soup& soup,
                                                           std::string_view bytes);

}  // namespace meshalyzer
