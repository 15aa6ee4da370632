#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace meshalyzer {

/// The content of a binary OFF file.
struct BinaryOff {
  Soup soup;
  /// The numbers of colours and texture coordinates, which the soup does not hold.
  std::size_t n_vertex_colours = 0;
  std::size_t n_face_colours = 0;
  std::size_t n_texture_points = 0;
};

/// Reads binary OFF as Geomview defines it: a line of the keyword and BINARY, then 32-bit whole
/// numbers and floats, the most significant byte first: the three counts, the vertices, the faces,
/// each with the number of its colour components and these.
///
/// @param name  The name of the file in messages.
/// @throws IoError with the byte offset of the first fault, TextFault if the first line is wrong.
/// @complexity O(bytes) time and memory, whatever the counts.
[[nodiscard]] BinaryOff parse_binary_off(std::string_view content, const std::string& name);

}  // namespace meshalyzer
