#pragma once

#include "meshalyzer/base/colour_map.h"
#include "meshalyzer/base/types.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// A value and a colour for each of some elements. The struct only refers to them.
struct ColouredValues {
  /// The values, NaN if there is none.
  std::span<const double> values;
  /// One colour for each value.
  std::span<const Colour> colours;
};

/// A mesh and a field on it, to be written to a file. The struct only refers to them.
struct MeshField {
  /// #V.
  std::span<const Vec3> positions;
  /// #F: the triangles, as indices into `positions`.
  std::span<const Triangle> triangles;
  /// The name of the values, of letters, digits and '-'.
  std::string_view name = "quality";
  /// #V.
  ColouredValues vertices;
  /// #F if the field has face values, from which those of the vertices are computed; else empty.
  ColouredValues faces;
  /// Sentences for a person, without line ends, for formats that have comments.
  std::vector<std::string> comments;
};

/// The formats that hold a field.
enum class FieldFormat : std::uint8_t {
  /// Binary little-endian PLY with the properties that viewers know: `quality` (double), `red`,
  /// `green` and `blue` (uchar), of vertices and, for a field of faces, also of faces.
  Ply,
  /// Wavefront OBJ: the colours of vertices behind their coordinates, from 0 to 1, and the values
  /// as texture coordinates `vt value 0`, in the order of the vertices. The format cannot hold a
  /// value that is not finite: its `vt` is `0 0`, and faces with such a corner name no `vt`.
  Obj,
  /// VTK's XML PolyData, its arrays in base64: the values under the field's name as the scalars of
  /// the points and, for a field of faces, of the cells; colours as `RGB`.
  Vtp,
};

/// Returns the format for the ending of a file name, ignoring case: `.ply`, `.obj` or `.vtp`.
[[nodiscard]] std::optional<FieldFormat> field_format_of_name(std::string_view name);

/// Returns the content of a file of a mesh and a field on it. Vertices, faces and their values keep
/// their order. All numbers read back to the last bit, except OBJ's colours, which viewers round to
/// the same byte.
///
/// @throws InvalidArgument if the numbers of values, colours and elements differ, or a corner is no
///         vertex.
/// @complexity O(#V + #F)
[[nodiscard]] std::string print_mesh_field(const MeshField& field, FieldFormat format);

}  // namespace meshalyzer
