#pragma once

#include "meshalyzer/repair/pass.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// An edge component of which every face is thin, so that no surface could take its place.
struct FlatComponents {
  /// Their faces, ascending.
  std::vector<Index> faces;
  /// The faces of those components whose corners are all within the maximum deviation of the rest
  /// of the mesh, so that the surface loses nothing without them. Each list is ascending.
  std::vector<std::vector<Index>> needless;
};

/// @param thin_faces  Thin faces of the complex, ascending.
/// @complexity        O(#F log #F).
[[nodiscard]] FlatComponents find_flat_components(const PassInput& input,
                                                  std::span<const Index> thin_faces);

}  // namespace meshalyzer
