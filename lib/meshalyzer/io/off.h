#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Reads OFF: [ST][C][N]OFF or no keyword, counts, a line a vertex, a line a face; or its binary
/// encoding.
///
/// @param name  Stands in messages.
/// @throws IoError with the first faulty line, in binary content with the byte offset.
/// @complexity O(bytes) time and memory, whatever the counts.
[[nodiscard]] Soup parse_off(std::string_view content, const std::string& name);

/// Writes OFF, or NOFF where the soup has one normal a vertex.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] std::string print_off(const Soup& soup);

}  // namespace meshalyzer
