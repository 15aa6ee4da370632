#pragma once

#include "meshalyzer/repair/pass.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Components of which every face is thin, so that no surface could take their place.
struct FlatComponents {
  /// Their faces, ascending.
  std::vector<Index> faces;
  /// The faces of those components that are all within the maximum deviation of the rest of the
  /// mesh, so that the surface loses nothing without them. Each list is ascending.
  std::vector<std::vector<Index>> needless;
};

/// @param thin_faces  Thin faces of the complex, ascending.
/// @complexity        O(#F log #F).
[[nodiscard]] FlatComponents find_flat_components(const PassInput& input,
                                                  std::span<const Index> thin_faces);

/// Finds components without a body: they are closed, some of their faces are thin and some are not,
/// and the mean distance of the layers of their surface from each other is below the tolerance, as
/// in a sliver of a tetrahedron.
///
/// @param thin_faces  Thin faces of the complex, ascending.
/// @return            The faces, ascending, of each that is within the maximum deviation of the
///                    rest of the mesh.
/// @complexity        O(#F log #F).
[[nodiscard]] std::vector<std::vector<Index>> find_needless_layers(
    const PassInput& input, std::span<const Index> thin_faces);

}  // namespace meshalyzer
