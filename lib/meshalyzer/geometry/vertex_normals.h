#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Tells how the normals of the faces are weighted in the normal of a vertex.
enum class NormalWeight : std::uint8_t {
  /// The same for all: equation 1 of the laboratory report (Gouraud 1971).
  Uniform,
  /// Its area.
  Area,
  /// The angle it has at the vertex. This weight alone gives the same normal however a flat facet
  /// is cut into triangles (Thürmer and Wüthrich 1998, "Computing vertex normals from polygonal
  /// facets").
  Angle,
};

/// Returns the normals of the file's vertices: the weighted sum of the unit normals of the faces
/// round each, made of length 1.
///
/// Where the file's complex is cut open, the copies of a vertex count together. Faces of zero area
/// count for nothing.
///
/// @return #file vertices; zero where there is no normal: at a vertex without faces of non-zero
/// area, and where the faces cancel each other to rounding.
/// @complexity O(#F).
[[nodiscard]] std::vector<Vec3> vertex_normals(const CutMesh& cut,
                                               NormalWeight weight = NormalWeight::Angle);

}  // namespace meshalyzer
