#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// A sum of weighted unit normals that is shorter than this share of the weights has no correct
/// digits: the faces cancel each other.
inline constexpr double kNormalsCancel = 1e-12;

/// The weight of the normal of a face in that of a vertex.
enum class NormalWeight : std::uint8_t {
  /// All faces have the same weight (Gouraud 1971).
  Uniform,
  /// The weight is the area of the face.
  Area,
  /// The weight is the angle of the face at the vertex. Only this weight gives the same normal
  /// however a flat facet is triangulated (Thürmer and Wüthrich 1998, "Computing vertex normals
  /// from polygonal facets").
  Angle,
};

/// Returns the normals of the file's vertices: the normalised weighted sums of the unit normals of
/// their faces.
///
/// Copies of a vertex, where the complex was cut open, count together. Faces of zero area are
/// ignored.
///
/// @return #file vertices: the normals, zero at a vertex without faces of non-zero area and where
///         the faces cancel each other to rounding.
/// @complexity O(#F).
[[nodiscard]] std::vector<Vec3> vertex_normals(const CutMesh& cut,
                                               NormalWeight weight = NormalWeight::Angle);

}  // namespace meshalyzer
