#pragma once

#include "meshalyzer/repair/holes/internal/existing_edges.h"

#include <vector>

namespace meshalyzer {

/// A patch as a half-edge mesh, in which it can be refined.
struct WorkingPatch {
  TriMesh mesh;
  /// Indexed by vertex: its file vertex; vertices beyond the end are new.
  std::vector<Index> names;
  /// Indexed by vertex: how long the edges there should be; empty before the first refinement.
  std::vector<double> spacing = {};

  [[nodiscard]] bool is_new(VertexHandle v) const {
    return static_cast<std::size_t>(v.idx()) >= names.size();
  }
};

/// Splits and flips until triangles are about as large as the faces round the loop (Liepa 2003,
/// "Filling holes in meshes", section 4): a vertex is put into a triangle where it comes to lie
/// farther from the corners than the edges there are long, and edges are flipped where the angles
/// opposite add up to more than 180 degrees.
///
/// A patch that was moved since it was refined is refined further where it has grown.
///
/// No edge is made that the mesh has, and no more than some 50,000 vertices: larger patches stay
/// coarser than what is round them.
///
/// @complexity  O(n log n) for n triangles.
void refine_patch(const PreparedMesh& mesh, const HoleLoop& loop, const ExistingEdges& existing,
                  WorkingPatch& patch);

}  // namespace meshalyzer
