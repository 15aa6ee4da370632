#pragma once

#include "meshalyzer/repair/facets/internal/facet_shape.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"
#include "meshalyzer/repair/facets/turning_over.h"

#include <cstddef>
#include <span>

namespace meshalyzer {

/// A face round a place that a step would change, before and after it.
struct FaceChange {
  Index number;
  /// The corners after the step.
  Triangle corners;
  /// Tells whether the face goes, because two of its corners become one.
  bool goes;
  Corners before;
  Corners after;
  /// The shape before the step.
  FacetShape shape;
};

/// @param step     Says which vertex it moves or adds; the faces it changes may be missing.
/// @param corners  The corners after the step.
[[nodiscard]] FaceChange change_of_face(const WorkingMesh& mesh, const MendStep& step, Index face,
                                        const Triangle& corners);

/// Tells whether the faces stay sound: none is turned over, unless that is permitted, and none
/// becomes thin unless more thin faces go.
///
/// @param n_thin_gone  The number of thin faces that go beside these.
/// @return             Possible, TurnsOver or MakesThin.
[[nodiscard]] MendOutcome check_shapes(const WorkingMesh& mesh, std::span<const FaceChange> faces,
                                       std::size_t n_thin_gone, double tolerance,
                                       TurningOver turning = TurningOver::Forbidden);

/// Appends those of the changes that are any to a step.
void write_changes(const WorkingMesh& mesh, std::span<const FaceChange> faces, MendStep& step);

}  // namespace meshalyzer
