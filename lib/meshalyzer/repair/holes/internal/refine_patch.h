#pragma once

#include "meshalyzer/repair/holes/internal/fill_task.h"
#include "meshalyzer/repair/holes/internal/hole_loop.h"

#include <vector>

namespace meshalyzer {

/// A patch as a half-edge mesh, in which it can be refined.
struct WorkingPatch {
  TriMesh mesh;
  /// Indexed by vertex: its file vertex; vertices beyond the end are new.
  std::vector<Index> names;
  /// Indexed by vertex: the target length of its edges; empty before the first refinement.
  std::vector<double> spacing = {};

  [[nodiscard]] bool is_new(VertexHandle v) const {
    return static_cast<std::size_t>(v.idx()) >= names.size();
  }
};

/// Splits and flips until triangles are about as large as the faces round the loop (Liepa 2003,
/// "Filling holes in meshes", section 4): a vertex is inserted into a triangle if its distance from
/// the corners exceeds the target length of the edges there, and edges are flipped if the opposite
/// angles add up to more than 180 degrees.
///
/// A patch that was moved since its last refinement is refined further where it has grown.
///
/// No edge is made that the mesh has, and no more than some 50,000 vertices: larger patches stay
/// coarser than their surroundings. The refinement ends early if the task is to stop.
///
/// @complexity  O(n log n) for n triangles.
void refine_patch(const FillTask& task, const HoleLoop& loop, WorkingPatch& patch);

}  // namespace meshalyzer
