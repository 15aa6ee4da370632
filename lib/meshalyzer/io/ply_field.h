#pragma once

#include "meshalyzer/base/colour_map.h"
#include "meshalyzer/base/types.h"

#include <span>
#include <string>

namespace meshalyzer {

/// A value and a colour for each vertex of a mesh. Only referred to.
struct VertexField {
  /// #V, NaN where there is none.
  std::span<const double> values;
  /// #V.
  std::span<const Colour> colours;
};

/// The content of a binary little-endian PLY file of a mesh and a field on its vertices, which
/// stands in the properties that viewers know: `quality` (double), `red`, `green` and `blue`
/// (uchar).
///
/// @param triangles  Indices into `positions`.
/// @throws InvalidArgument where the field is not of as many vertices, or a corner is no vertex.
/// @complexity       O(#V + #F)
[[nodiscard]] std::string print_ply_field(std::span<const Vec3> positions,
                                          std::span<const Triangle> triangles,
                                          const VertexField& field);

}  // namespace meshalyzer
