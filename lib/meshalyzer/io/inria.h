#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Reads INRIA's text `.mesh` (MeshVersionFormatted): Vertices, Triangles, Quadrilaterals; other
/// sections are skipped.
///
/// @param name  The name of the file in messages.
/// @throws IoError with the first faulty line.
/// @complexity O(bytes) time and memory, whatever the counts.
[[nodiscard]] Soup parse_inria(std::string_view text, const std::string& name);

/// Writes Vertices and Triangles, with all references 0.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] std::string print_inria(const Soup& soup);

}  // namespace meshalyzer
