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

/// Counts what of that is not in a file that print_mesh() makes of a soup.
///
/// @param source   The attributes of the file that the soup was made of.
/// @param printed  The soup that is printed, and its format.
[[nodiscard]] std::vector<AttributeCount> lost_attributes(std::vector<AttributeCount> source,
                                                          const Soup& printed, Format format);

}  // namespace meshalyzer
