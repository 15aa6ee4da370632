#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Reads PLY 1.0, ASCII or binary in either byte order: x y z, nx ny nz and the vertex_indices (or
/// vertex_index) of faces and of strips of triangles (`tristrips`); every other property and
/// element is skipped.
///
/// @param name  The name of the file in messages.
/// @throws IoError with the first faulty line, in binary content with the byte offset.
/// @complexity O(bytes) time and memory, whatever the header counts.
[[nodiscard]] Soup parse_ply(std::string_view content, const std::string& name);

/// Writes ASCII PLY: coordinates as doubles, and normals if the soup has one for each vertex.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] std::string print_ascii_ply(const Soup& soup);

/// Writes little-endian binary PLY with the same content.
[[nodiscard]] std::string print_binary_ply(const Soup& soup);

}  // namespace meshalyzer
