#pragma once

#include "meshalyzer/repair/pass.h"
#include "meshalyzer/topology/components.h"

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

/// The edge components of a mesh, and the numbers of their faces.
struct ThinComponents {
  Components components;
  /// #components: how many faces each has, and how many of them are thin.
  std::vector<Index> n_faces;
  std::vector<Index> n_thin;
};

/// @param thin_faces  Thin faces of the complex.
/// @complexity        O(#E log #F).
[[nodiscard]] ThinComponents count_thin_faces(const CutMesh& cut,
                                              std::span<const Index> thin_faces);

/// @param thin_faces  Thin faces of the complex, ascending.
/// @param counted     The result of count_thin_faces().
/// @complexity        O(#F log #F).
[[nodiscard]] FlatComponents find_flat_components(const PassInput& input,
                                                  std::span<const Index> thin_faces,
                                                  const ThinComponents& counted);

/// Finds components without a body: they are closed, some of their faces are thin and some are not,
/// and the mean distance of the layers of their surface from each other is below the tolerance, as
/// in a sliver of a tetrahedron.
///
/// @param counted  The result of count_thin_faces().
/// @return         The faces, ascending, of each that is within the maximum deviation of the rest
///                 of the mesh.
/// @complexity     O(#F log #F).
[[nodiscard]] std::vector<std::vector<Index>> find_needless_layers(const PassInput& input,
                                                                   const ThinComponents& counted);

}  // namespace meshalyzer
