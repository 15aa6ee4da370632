#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/repair/driver/rejection.h"

#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

/// An operation that was applied, and all that it changed. Elements are named by key, see
/// TrackedMesh.
struct LoggedOperation {
  /// Index into RepairLog::steps.
  Index step = 0;
  std::vector<Index> removed_faces;
  std::vector<Index> added_faces;
  std::vector<Index> changed_faces;
  std::vector<Index> removed_vertices;
  std::vector<Index> added_vertices;
  std::vector<Index> moved_vertices;
  /// Largest distance that a vertex, or a corner of a face, was moved. In the mesh's unit.
  double distance = 0.0;
};

/// A step of a repair: a pass that changed something.
struct LogStep {
  /// "mend facets", ...
  std::string pass;
  /// What it treats.
  DefectCode code = DefectCode::Corrupt;
  std::size_t operations = 0;
  /// Operations that were proposed, and left out again for what they would have done.
  std::size_t undone = 0;
  std::size_t faces_removed = 0;
  std::size_t faces_added = 0;
  std::size_t faces_changed = 0;
  std::size_t vertices_removed = 0;
  std::size_t vertices_added = 0;
  std::size_t vertices_moved = 0;
  double distance = 0.0;
};

/// A defect that a pass looked at and left, or an operation that was undone, and why.
struct LoggedRefusal {
  std::string pass;
  DefectCode code = DefectCode::Corrupt;
  /// Keys, kNoIndex where there is none.
  Index vertex = kNoIndex;
  Index face = kNoIndex;
  std::string reason;
  /// The rule of acceptance that stands against a repair; None where it is something else.
  Rejection rejection = Rejection::None;
};

/// All that a repair did and did not do.
struct RepairLog {
  std::vector<LogStep> steps;
  /// The operations in order of their steps.
  std::vector<LoggedOperation> operations;
  /// What still is refused in the end.
  std::vector<LoggedRefusal> refusals;
};

}  // namespace meshalyzer
