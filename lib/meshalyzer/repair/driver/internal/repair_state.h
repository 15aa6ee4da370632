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

  /// Updates the pairs after a change: only the pairs of the faces that it affected are searched.
  RepairState(TrackedMesh tracked, const Tolerances& tolerances, const RepairState& before,
              const AffectedElements& affected);

  RepairState(const RepairState&) = delete;
  RepairState& operator=(const RepairState&) = delete;

  [[nodiscard]] const TrackedMesh& tracked() const { return tracked_; }
  [[nodiscard]] const PreparedMesh& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<DefectiveElement>& defective_elements() const {
    return defective_elements_;
  }
  /// Returns the pairs that the last change affected, by index.
  [[nodiscard]] const std::vector<IntersectingPair>& affected_pairs() const {
    return affected_pairs_;
  }

 private:
  TrackedMesh tracked_;
  PreparedMesh mesh_;
  std::vector<DefectiveElement> defective_elements_;
  std::vector<IntersectingPair> affected_pairs_;
};

}  // namespace meshalyzer
