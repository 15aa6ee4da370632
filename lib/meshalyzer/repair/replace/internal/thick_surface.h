#pragma once

#include "meshalyzer/mesh/soup.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// A closed surface round a sheet.
struct ThickSurface {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// #triangles: the face of the soup that each was made of.
  std::vector<Index> origins;
};

/// Gives faces a second side and moves both apart: a closed, consistently oriented surface that
/// goes round the faces once, whatever they are, also where they are one-sided. Round an edge each
/// side is joined to the side that faces it; borders get a rim.
///
/// Where the faces bend sharply, or cross, parts of it may cross.
///
/// @param faces      Of the complex, no two with the same vertices.
/// @param thickness  How far the two sides of a flat sheet are apart.
/// @complexity       O(n log n).
[[nodiscard]] ThickSurface thicken(const Soup& soup, std::span<const Index> faces,
                                   double thickness);

}  // namespace meshalyzer
