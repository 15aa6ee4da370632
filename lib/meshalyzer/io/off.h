#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Reads OFF: [ST][C][N]OFF or no keyword, counts, one line for each vertex, one line for each
/// face; or its binary encoding.
///
/// @param name  The name of the file in messages.
/// @throws IoError with the first faulty line, in binary content with the byte offset.
/// @complexity O(bytes) time and memory, whatever the counts.
[[nodiscard]] Soup parse_off(std::string_view content, const std::string& name);

/// Writes OFF, or NOFF if the soup has one normal for each vertex.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] std::string print_off(const Soup& soup);

}  // namespace meshalyzer
