#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/repair/driver/rejection.h"

#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

/// An operation that was applied, and all its changes. Elements are named by key, see TrackedMesh.
struct LoggedOperation {
  /// The index of its step in RepairLog::steps.
  Index step = 0;
  std::vector<Index> removed_faces;
  std::vector<Index> added_faces;
  std::vector<Index> changed_faces;
  std::vector<Index> removed_vertices;
  std::vector<Index> added_vertices;
  std::vector<Index> moved_vertices;
  /// The largest distance by which a vertex, or a corner of a face, was moved. In the mesh's unit.
  double distance = 0.0;
};

/// A step of a repair: a pass that changed something.
struct LogStep {
  /// The name of the pass: "mend facets", ...
  std::string pass;
  /// The code of the defect that the pass repairs.
  DefectCode code = DefectCode::Corrupt;
  std::size_t operations = 0;
  /// The number of operations that were proposed and rejected for their effects.
  std::size_t undone = 0;
  std::size_t faces_removed = 0;
  std::size_t faces_added = 0;
  std::size_t faces_changed = 0;
  std::size_t vertices_removed = 0;
  std::size_t vertices_added = 0;
  std::size_t vertices_moved = 0;
  double distance = 0.0;
};

/// A defect that a pass examined and left, or an operation that was undone, and the reason.
struct LoggedRefusal {
  std::string pass;
  DefectCode code = DefectCode::Corrupt;
  /// The keys of the vertex and the face that name it, or kNoIndex.
  Index vertex = kNoIndex;
  Index face = kNoIndex;
  std::string reason;
  /// The rule of acceptance that prevents the repair; None if the reason is another.
  Rejection rejection = Rejection::None;
};

/// The log of a repair: the operations that were applied, and the defects that were left.
struct RepairLog {
  std::vector<LogStep> steps;
  /// The operations in order of their steps.
  std::vector<LoggedOperation> operations;
  /// The defects that are still refused after the last pass.
  std::vector<LoggedRefusal> refusals;
};

}  // namespace meshalyzer
