#pragma once

#include "meshalyzer/repair/holes/internal/fill_task.h"
#include "meshalyzer/repair/holes/internal/hole_loop.h"
#include "meshalyzer/repair/holes/internal/patch_check.h"

#include <cstddef>
#include <optional>

namespace meshalyzer {

/// Refines a patch to the density of the mesh round it, and fairs it: its new vertices continue the
/// curvature of the surroundings (Liepa 2003, "Filling holes in meshes").
///
/// @param patch    A triangulation of the loop, and a manifold.
/// @param max_new  Bounds the number of new vertices as refine_patch() does.
/// @return         Nothing if the patch needs no new vertex, or if the fair surface cannot be
/// computed in floating point, or if the task is to stop.
[[nodiscard]] std::optional<Patch> smooth_patch(const FillTask& task, const HoleLoop& loop,
                                                const Patch& patch, std::size_t max_new);

}  // namespace meshalyzer
