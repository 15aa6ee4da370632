#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Reads OFF text: [ST][C][N]OFF or no keyword, counts, a line a vertex, a line a face.
///
/// @param name  Stands in messages.
/// @throws IoError with the first faulty line.
/// @complexity O(bytes) time and memory, whatever the counts.
[[nodiscard]] Soup parse_off(std::string_view text, const std::string& name);

/// Writes OFF, or NOFF where the soup has one normal a vertex.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] std::string print_off(const Soup& soup);

/// Whether the word is OFF with any of its prefixes, those that are not read included.
[[nodiscard]] bool is_off_keyword(std::string_view word);

}  // namespace meshalyzer
