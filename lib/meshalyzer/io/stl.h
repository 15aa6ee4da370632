#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>
#include <string_view>

namespace meshalyzer {

/// Reads STL: binary if the size is that of a binary file (is_binary_stl()) or the text contains
/// zero bytes, else ASCII.
///
/// Bit-identical points become one vertex, see Soup. The facets' normals are not kept.
///
/// @param name  The name of the file in messages.
/// @throws IoError with the first faulty line, in binary content with the byte offset.
/// @complexity O(bytes) time and memory, whatever the header counts.
[[nodiscard]] Soup parse_stl(std::string_view content, const std::string& name);

/// Writes ASCII STL with full precision and the facets' unit normals; unused vertices are not
/// written.
/// @throws InvalidArgument if a face has a corner without a vertex.
[[nodiscard]] std::string print_ascii_stl(const Soup& soup);

/// Writes binary STL with the nearest 32-bit floats.
/// @throws InvalidArgument if a face has a corner without a vertex, or a coordinate is beyond the
/// floats.
[[nodiscard]] std::string print_binary_stl(const Soup& soup);

/// Tells whether 32-bit floats, as binary STL has them, represent all coordinates exactly.
[[nodiscard]] bool fits_floats(const Soup& soup);

/// Returns the unit normal of a face, or zero if its area is zero or underflows.
[[nodiscard]] Vec3 unit_normal(const Soup& soup, const Triangle& triangle);

/// Tells whether the size is 84 + 50 n bytes, n being the 32-bit number at byte 80.
[[nodiscard]] bool is_binary_stl(std::string_view content);

}  // namespace meshalyzer
