#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// The normals of the file's vertices: the sum of the unit normals of the faces round each,
/// weighted by the angle that the face has there, made of length 1.
///
/// This weight alone gives the same normal however a flat facet is cut into triangles (Thürmer and
/// Wüthrich 1998, "Computing vertex normals from polygonal facets"). Where the file's complex is
/// cut open, the copies of a vertex count together. Faces of zero area count for nothing.
///
/// @return #file vertices; zero where there is no normal: at a vertex without faces of non-zero
/// area, and where the faces cancel each other to rounding.
/// @complexity O(#F).
[[nodiscard]] std::vector<Vec3> vertex_normals(const CutMesh& cut);

}  // namespace meshalyzer
