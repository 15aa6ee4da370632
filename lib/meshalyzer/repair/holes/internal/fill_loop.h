#pragma once

#include "meshalyzer/repair/holes/internal/join_loops.h"
#include "meshalyzer/repair/holes/internal/loop_polygon.h"
#include "meshalyzer/repair/holes/internal/patch_check.h"
#include "meshalyzer/repair/passes.h"

#include <optional>
#include <string>
#include <vector>

namespace meshalyzer {

/// What filling a loop takes.
struct FillTask {
  const PreparedMesh& mesh;
  const ExistingEdges& existing;
  /// Triangles with an altitude below this are avoided. In the mesh's unit.
  double degeneracy = 0.0;
  FillShape shape = FillShape::Auto;
};

/// What became of a loop.
struct Filling {
  /// Meets neither the mesh nor itself.
  std::optional<Patch> patch;
  /// Why there is none.
  std::string reason;
  /// File faces that the first patch that was tried meets. Ascending.
  std::vector<Index> met_faces;
};

/// Returns the patch that is tried first; nothing where no triangulation is possible.
[[nodiscard]] std::optional<Patch> first_patch(const FillTask& task, const JoinedLoop& loop);

/// Looks for a patch: the best triangulation; others that avoid those of its triangles that meet
/// something; and where none will do, patches with new vertices.
[[nodiscard]] Filling fill_loop(const FillTask& task, const JoinedLoop& loop);

}  // namespace meshalyzer
