#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// A mesh of which some vertices were moved off other meshes that it touched.
struct PartedMesh {
  const Soup& mesh;
  /// The positions of its vertices before.
  const std::vector<Vec3>& start;
  const Soup& others;
  /// The pairs of a face of the mesh and one of the others that had a point in common before.
  std::span<const IntersectingPair> touching;
  /// Those that have one now.
  std::span<const IntersectingPair> left;
  /// A vertex was on a face if it was not farther from it than this.
  double near = 0.0;
};

/// Finds the faces of the others that are in the way: those that the mesh still meets, and those on
/// which vertices lay whose move makes faces of the mesh intersect.
///
/// @return      The faces, ascending.
/// @complexity  That of find_self_intersections_of() for the faces of moved vertices.
[[nodiscard]] std::vector<Index> find_blocking_faces(const PartedMesh& moved);

}  // namespace meshalyzer
