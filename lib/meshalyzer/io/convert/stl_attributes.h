#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// Returns the solids of an ASCII STL file if any has a name, else nothing.
[[nodiscard]] std::vector<Group> named_solids(std::string_view text);

/// Returns the attribute word of each facet of a binary STL file.
[[nodiscard]] std::vector<std::uint16_t> read_attribute_words(std::string_view content,
                                                              std::size_t n_facets);

/// Returns the header of a binary STL file without the blanks and zeros at its end.
[[nodiscard]] std::string_view stl_header(std::string_view content);

}  // namespace meshalyzer
