#pragma once

#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/edits/draft.h"
#include "meshalyzer/repair/edits/touched.h"
#include "meshalyzer/repair/trial/flaws.h"

#include <utility>
#include <vector>

namespace meshalyzer {

/// A draft and all that is known of it. Stays where it is: the mesh refers to the draft's soup.
class RepairState {
 public:
  /// Searches the whole mesh for intersecting pairs.
  RepairState(Draft draft, const Tolerances& tolerances);

  /// After a change: only the pairs of the faces that it touched are searched.
  RepairState(Draft draft, const Tolerances& tolerances, const RepairState& before,
              const Touched& touched);

  RepairState(const RepairState&) = delete;
  RepairState& operator=(const RepairState&) = delete;

  [[nodiscard]] const Draft& draft() const { return draft_; }
  [[nodiscard]] const PreparedMesh& mesh() const { return mesh_; }
  [[nodiscard]] const std::vector<Flaw>& flaws() const { return flaws_; }
  /// The pairs that the last change touched; by index.
  [[nodiscard]] const std::vector<IntersectingPair>& touched_pairs() const {
    return touched_pairs_;
  }

 private:
  Draft draft_;
  PreparedMesh mesh_;
  std::vector<Flaw> flaws_;
  std::vector<IntersectingPair> touched_pairs_;
};

}  // namespace meshalyzer
