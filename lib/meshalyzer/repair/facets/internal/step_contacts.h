#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"

#include <vector>

namespace meshalyzer {

/// Foresees which steps would be undone because they bring faces into contact. It refers to the
/// meshes.
class StepContacts {
 public:
  /// @param before  The mesh before all steps.
  /// @param now     The same mesh after those made so far.
  StepContacts(const PreparedMesh& before, const WorkingMesh& now) : before_(before), now_(now) {}

  /// Tells whether one of the faces that a step makes comes into contact with a face with which
  /// none of those that it takes away is in contact. Of faces that earlier steps have moved to
  /// another place, only neighbours are examined; and nothing is foreseen where very many faces
  /// are near.
  ///
  /// @complexity  O(n log #F) for n faces nearby.
  [[nodiscard]] bool are_made_by(const MendStep& step) const;

 private:
  struct Change;
  [[nodiscard]] Change change_of(const MendStep& step) const;
  [[nodiscard]] std::vector<Index> faces_near(const Change& change) const;

  const PreparedMesh& before_;
  const WorkingMesh& now_;
};

}  // namespace meshalyzer
