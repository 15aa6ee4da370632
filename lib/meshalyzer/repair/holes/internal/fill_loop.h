#pragma once

#include "meshalyzer/repair/holes/internal/fill_task.h"
#include "meshalyzer/repair/holes/internal/join_loops.h"
#include "meshalyzer/repair/holes/internal/patch_check.h"

#include <optional>
#include <string>

namespace meshalyzer {

/// The outcome of filling a loop.
struct Filling {
  /// The patch, which intersects neither the mesh nor itself.
  std::optional<Patch> patch;
  /// The reason why there is none.
  std::string reason;
  /// If there is no patch, what first_patch() returns.
  std::optional<Patch> first;
};

/// Returns the patch that is tried first; nothing if no triangulation is possible.
[[nodiscard]] std::optional<Patch> first_patch(const FillTask& task, const JoinedLoop& loop);

/// Searches for a patch: tries the best triangulation, then others without those of its triangles
/// that intersect something, and if none is free of intersections, patches with new vertices.
[[nodiscard]] Filling fill_loop(const FillTask& task, const JoinedLoop& loop);

}  // namespace meshalyzer
