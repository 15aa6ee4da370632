#pragma once

#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/driver/internal/defective_elements.h"
#include "meshalyzer/repair/edits/internal/affected_elements.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <utility>
#include <vector>

namespace meshalyzer {

/// A tracked mesh and the data computed for it. It is neither copied nor moved, because the
/// prepared mesh refers to the soup.
class RepairState {
 public:
  /// Searches the whole mesh for intersecting pairs.
  RepairState(TrackedMesh tracked, const Tolerances& tolerances, PairLimits limits = {});

  /// Takes intersecting pairs that are known.
  ///
  /// @param pairs  All pairs of the mesh, as find_self_intersections() returns them.
  RepairState(TrackedMesh tracked, const Tolerances& tolerances,
              std::vector<IntersectingPair> pairs);

  /// States whose intersecting pairs are known. It only refers to them.
  struct KnownStates {
    /// The state before a change.
    const RepairState& before;
    /// The result of a change that was tried before, made from the same state: of the same edits
    /// with fewer operations skipped.
    const RepairState* trial = nullptr;
  };

  /// Updates the pairs after a change: only the pairs of faces are searched that are new, or have
  /// got other vertices or positions, since the known state with the fewest of these.
  RepairState(TrackedMesh tracked, const Tolerances& tolerances, const KnownStates& known,
              const AffectedElements& affected);

  RepairState(const RepairState&) = delete;
  RepairState& operator=(const RepairState&) = delete;

  [[nodiscard]] const TrackedMesh& tracked() const { return tracked_; }
  [[nodiscard]] const PreparedMesh& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<DefectiveElement>& defective_elements() const {
    return defective_elements_;
  }
  /// Returns the pairs of the faces that the last change affected, by index.
  [[nodiscard]] const std::vector<IntersectingPair>& affected_pairs() const {
    return affected_pairs_;
  }
  /// Returns the keys of the faces that the last change affected, ascending.
  [[nodiscard]] const std::vector<Index>& affected_faces() const { return affected_faces_; }

 private:
  TrackedMesh tracked_;
  PreparedMesh mesh_;
  std::vector<DefectiveElement> defective_elements_;
  std::vector<IntersectingPair> affected_pairs_;
  std::vector<Index> affected_faces_;
};

}  // namespace meshalyzer
