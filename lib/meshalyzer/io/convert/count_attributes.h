#pragma once

#include "meshalyzer/io/attributes.h"
#include "meshalyzer/mesh/soup.h"

#include <string_view>
#include <vector>

namespace meshalyzer {

/// Counts the attributes that a file holds in addition to vertices and triangles.
///
/// @param soup   The soup that was read from the bytes.
/// @complexity   O(bytes).
[[nodiscard]] std::vector<AttributeCount> count_attributes(const Soup& soup,
                                                           std::string_view bytes);

}  // namespace meshalyzer
