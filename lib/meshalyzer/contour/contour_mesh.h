#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace meshalyzer {

/// The limits of contour_mesh().
struct ContourLimits {
  /// The largest distance between the contour and the part of the mesh that bounds its solid;
  /// positive, in the mesh's unit.
  double max_deviation = 0.0;
  /// The largest number of tetrahedra of the grid.
  std::size_t max_tetrahedra = 4'000'000;
  /// If given, the contour is that of the part of the solid in this box, which must neither be
  /// empty nor a point, and a little beyond it, where it is closed by any surface. Only what lies
  /// in the box is refined and compared.
  std::optional<Box3> within = {};
  /// Called now and then, from any thread; once it returns true, no contour is found.
  StopQuery wants_to_stop = {};
};

/// The result of contour_mesh().
struct ContouredMesh {
  /// The mesh, which is closed, manifold, outward and free of self-intersections, or has no faces.
  Soup soup;
  /// The faces of the input, or pieces of them, that do not bound the solid: walls inside it, and
  /// sheets outside.
  std::vector<Corners> walls;
  /// The largest distance between the surfaces at the sample points.
  double deviation = 0.0;
  /// The number of tetrahedra of the grid.
  std::size_t n_tetrahedra = 0;
  /// Tells whether the deviation is within the limit. If not, the grid would have needed more
  /// tetrahedra.
  bool is_within = false;
};

/// Makes a mesh that bounds the solid which another mesh represents (MeshRegion), even if that mesh
/// is open, intersects itself or is not manifold.
///
/// It extracts a contour in a grid of tetrahedra (march_tetrahedra()), finds where the contour and
/// the mesh are too far apart, refines the grid there, and repeats. The comparison excludes walls,
/// and the parts of the contour that span holes.
///
/// @throws InvalidArgument  as build(); if the maximum deviation is not positive and finite; and if
/// a position is not finite.
/// @return     Nothing if the mesh has no extent, if its coordinates are too large relative to its
///             size for a grid, or if it was to stop.
/// @complexity O(tetrahedra log tetrahedra) per round; about 400 bytes per tetrahedron.
[[nodiscard]] std::optional<ContouredMesh> contour_mesh(const Soup& soup,
                                                        const ContourLimits& limits);

}  // namespace meshalyzer
