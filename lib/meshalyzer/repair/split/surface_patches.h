#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// The parts of a complex between its edges with more than two faces.
struct SurfacePatches {
  /// #mesh faces: the patch of each; faces joined through edges with two, whichever way oriented.
  std::vector<Index> of_face;
  /// By patch: border edges as a share of all edges at its rim; 0 where it has no rim.
  std::vector<double> openness;
};

/// @complexity O(#E log #F) time, near linear in practice.
[[nodiscard]] SurfacePatches find_surface_patches(const CutMesh& cut);

}  // namespace meshalyzer
