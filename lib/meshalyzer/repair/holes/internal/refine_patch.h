#pragma once

#include "meshalyzer/repair/holes/internal/fill_task.h"
#include "meshalyzer/repair/holes/internal/hole_loop.h"

#include <cstddef>
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
/// No edge is made that the mesh has. The refinement ends early if the task is to stop.
///
/// @param max_new  About this number of new vertices is made, and never more than twice as many:
/// where the patch would need more, it stays coarser than its surroundings.
/// @complexity  O(n log n) for n triangles.
void refine_patch(const FillTask& task, const HoleLoop& loop, std::size_t max_new,
                  WorkingPatch& patch);

}  // namespace meshalyzer
