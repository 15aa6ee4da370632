#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/contour/march_tetrahedra.h"
#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The parts of a surface that separate a region from the rest of space, and those that do not.
struct SurfaceParts {
  /// Points distributed over the separating parts.
  std::vector<Vec3> separating;
  /// The other parts, faces or pieces of faces, which lie in the interior of the region or outside.
  std::vector<Corners> walls;
};

/// The resolution of divide_surface().
struct PartsResolution {
  /// Neighbouring points are at most about this far apart.
  double spacing = 0.0;
  /// The two sides of a face are sampled at this distance from it.
  double reach = 0.0;
  /// Neighbouring points along creases are at most this far apart.
  double crease_spacing = 0.0;
  /// Pieces that other faces cross are divided down to this size.
  double least_piece = 0.0;
};

/// Properties of the faces of a mesh that are known beforehand.
struct FaceHints {
  /// The faces that intersect others, where a part of a face may separate and another may not: each
  /// pair in both orders, ascending.
  std::vector<std::array<Index, 2>> intersecting;
  /// #F: bit k is set if the edge that begins at corner k is a crease.
  std::vector<std::uint8_t> creases;
};

/// Finds which parts of a mesh separate a region from the rest of space.
///
/// @param wants_to_stop  Called now and then, from any thread; once it returns true, the parts mean
///                       nothing.
/// @complexity           O(#F + points) with one call of the region for each piece, and for each
///                       crease point of a face that intersects others, or of which only some
///                       pieces separate; four for a piece that others touch.
[[nodiscard]] SurfaceParts divide_surface(const Soup& soup, const Region& region,
                                          const FaceHints& hints, const PartsResolution& resolution,
                                          const StopQuery& wants_to_stop);

}  // namespace meshalyzer
