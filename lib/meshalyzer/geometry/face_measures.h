#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/side_table.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Returns the corners of a mesh face, counter-clockwise seen from the side its normal points to.
[[nodiscard]] Corners face_corners(const TriMesh& mesh, FaceHandle face);

/// The measures of each face.
struct FaceMeasures {
  /// #mesh faces: the area in the mesh's unit squared.
  std::vector<double> area;
  /// #mesh faces: longest edge over shortest altitude, at least 2 / sqrt(3); infinite for a face of
  /// zero area.
  std::vector<double> aspect_ratio;
  /// #mesh faces: the smallest of the three angles at the corners, in degrees; 0 for a face of zero
  /// area, else at most 60, to rounding.
  std::vector<double> corner_angle;
  /// Mesh faces whose corners are collinear, decided exactly. Ascending.
  std::vector<FaceHandle> zero_area;
};

/// Measures the faces of a mesh.
///
/// Slivers keep their digits: where floating point would lose them, the area is evaluated exactly
/// and then rounded. The figures do not depend on which corner of a face comes first, except for
/// ties of edge lengths.
///
/// @complexity O(#F).
[[nodiscard]] FaceMeasures measure_faces(const TriMesh& mesh);

/// Does the same for a caller that has the lengths of the edges already.
///
/// @param edge_lengths  The result of mesh_edge_lengths().
[[nodiscard]] FaceMeasures measure_faces(const TriMesh& mesh, std::span<const double> edge_lengths);

}  // namespace meshalyzer
