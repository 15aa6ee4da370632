#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// Returns the size in bytes of a binary number of the type.
[[nodiscard]] std::size_t size_of(PlyType type);

[[nodiscard]] constexpr bool is_integer(PlyType type) {
  return type != PlyType::Float32 && type != PlyType::Float64;
}

struct PlyProperty {
  std::string name;
  /// The type of the number, or of each item of the list.
  PlyType type = PlyType::Float32;
  /// The type of the number of items, if the property is a list.
  std::optional<PlyType> list_size_type;
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  /// The line of the header, from 1, on which the element is declared.
  std::size_t line = 0;
  std::vector<PlyProperty> properties;
};

/// The contents of the header of a PLY file. Names are unique; `vertex` has x, y and z, `face` and
/// `tristrips` one list of vertex indices.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  /// The number of lines up to and including `end_header`.
  std::size_t n_lines = 0;
  std::size_t n_bytes = 0;
};

/// Tells whether the records of this element are faces or strips of faces.
[[nodiscard]] bool has_corners(const PlyElement& element);

/// Tells whether this property of a face or strip is the list of its corners.
[[nodiscard]] bool is_corner_list(const PlyProperty& property);

/// Parses the header of a PLY file.
/// @throws TextFault with the first faulty line.
[[nodiscard]] PlyHeader parse_ply_header(std::string_view content);

}  // namespace meshalyzer
