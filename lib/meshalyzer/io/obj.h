#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Reads Wavefront OBJ: v, vn, f, g and o; every other statement of the format is skipped.
///
/// @param name  The name of the file in messages.
/// @throws IoError with the first faulty line.
/// @complexity O(bytes) time and memory.
[[nodiscard]] Soup parse_obj(std::string_view text, const std::string& name);

/// Writes v, vn, g and f.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] std::string print_obj(const Soup& soup);

/// Tells whether a statement of OBJ begins with this word.
[[nodiscard]] bool is_obj_keyword(std::string_view word);

}  // namespace meshalyzer
