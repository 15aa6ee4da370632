#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace meshalyzer {

/// What contour_mesh() may do.
struct ContourLimits {
  /// The contour and the part of the mesh that bounds its solid are to be at most so far apart;
  /// positive, in the mesh's unit.
  double max_deviation = 0.0;
  /// The grid has at most so many tetrahedra.
  std::size_t max_tetrahedra = 4'000'000;
};

/// What contour_mesh() has made.
struct ContouredMesh {
  /// Closed, manifold, outward, and free of self-intersections, or without faces.
  Soup soup;
  /// Faces of the mesh, or pieces of them, that do not bound the solid: walls inside it, and sheets
  /// outside.
  std::vector<Corners> walls;
  /// Tells how far the surfaces are apart, at the points that were looked at.
  double deviation = 0.0;
  /// Tells whether that is within the limit. Where not, the grid would have needed more tetrahedra.
  bool is_within = false;
};

/// Makes a mesh that bounds the solid which another mesh means (MeshRegion), whatever is wrong with
/// that one: open, crossing itself, not manifold.
///
/// Draws a contour in a grid of tetrahedra (march_tetrahedra()), looks where it is too far from the
/// mesh or the mesh from it, refines the grid there, and begins again. Walls are left out of the
/// comparison, and so is what the contour spans holes with.
///
/// @return     Nothing where the mesh has no extent, or its coordinates leave no room for a grid.
/// @complexity O(tetrahedra log tetrahedra) a round; about 400 bytes a tetrahedron.
[[nodiscard]] std::optional<ContouredMesh> contour_mesh(const Soup& soup,
                                                        const ContourLimits& limits);

}  // namespace meshalyzer
