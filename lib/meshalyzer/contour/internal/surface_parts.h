#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/contour/march_tetrahedra.h"
#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Tells which parts of a surface separate a region from the rest of space.
struct SurfaceParts {
  /// Points all over the parts that do.
  std::vector<Vec3> separating;
  /// The parts that do not, because they lie in the midst of the region or outside: faces, or
  /// pieces of faces.
  std::vector<Corners> walls;
};

/// Tells how closely divide_surface() looks.
struct PartsResolution {
  /// Neighbouring points are at most about this far apart.
  double spacing = 0.0;
  /// What is on the two sides of a face is asked at this distance from it.
  double reach = 0.0;
  /// Neighbouring points along creases are at most this far apart.
  double crease_spacing = 0.0;
  /// Pieces of faces of which one part separates and another does not are divided until they are as
  /// small as this.
  double least_piece = 0.0;
};

/// What is known of the faces of a mesh.
struct FaceHints {
  /// #F: 1 for faces of which one part may separate and another may not.
  std::vector<std::uint8_t> changes_inside;
  /// #F: bit k says that the edge which begins at corner k is a crease.
  std::vector<std::uint8_t> creases;
};

/// Finds which parts of a mesh separate a region from the rest of space.
///
/// @complexity  O(#F + points), two to eight questions to the region for each piece, and for each
/// point of a crease of a face that may change inside.
[[nodiscard]] SurfaceParts divide_surface(const Soup& soup, const Region& region,
                                          const FaceHints& hints,
                                          const PartsResolution& resolution);

}  // namespace meshalyzer
