#pragma once

#include "meshalyzer/contour/march_tetrahedra.h"
#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Which parts of a surface separate a region from the rest of space.
struct SurfaceParts {
  /// Points all over the parts that do.
  std::vector<Vec3> separating;
  /// The parts that do not, because they lie in the midst of the region or outside: faces, or
  /// pieces of faces.
  std::vector<std::array<Vec3, 3>> walls;
};

/// How closely divide_surface() looks.
struct PartsResolution {
  /// Neighbouring points are at most about this far apart.
  double spacing = 0.0;
  /// What is on the two sides of a face is asked at this distance from it, and pieces of faces of
  /// which one part separates and another does not are divided until they are as small as this.
  double reach = 0.0;
};

/// Finds which parts of a mesh separate a region from the rest of space.
///
/// @param changes_inside  #F: 1 for faces of which one part may separate and another may not.
/// @complexity            O(#F + pieces), two to eight questions to the region for each.
[[nodiscard]] SurfaceParts divide_surface(const Soup& soup, const Region& region,
                                          const std::vector<std::uint8_t>& changes_inside,
                                          const PartsResolution& resolution);

}  // namespace meshalyzer
