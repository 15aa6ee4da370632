#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/set/separation.h"
#include "meshalyzer/set/set_object.h"

#include <vector>

/// What the set module must say, straight from the definitions: slow, without trees or shortcuts.
/// Faces must not have zero area.
namespace meshalyzer::test {

/// The lengths of the shortest ways along edges from each vertex to each other (Floyd 1962,
/// Warshall 1962); infinite where there is none.
[[nodiscard]] std::vector<std::vector<double>> path_lengths(const Soup& soup);

/// The faces of those components of which every edge has exactly two faces.
[[nodiscard]] std::vector<Triangle> enclosing_faces(const Soup& soup);

/// Where a point lies with regard to these faces of a soup: how often a segment from it to a point
/// outside meets them, over the rationals.
[[nodiscard]] Side direct_side(const Soup& soup, const std::vector<Triangle>& faces,
                               const Vec3& point);

/// Finds it by asking closest_on_triangle() for every face.
[[nodiscard]] ObjectSeparation direct_separation(const std::vector<Soup>& objects, Index object,
                                                 const SeparationOptions& options = {});

}  // namespace meshalyzer::test
