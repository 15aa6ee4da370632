#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/repair/driver/deviation.h"
#include "meshalyzer/repair/driver/internal/repair_state.h"
#include "meshalyzer/repair/driver/rejection.h"
#include "meshalyzer/repair/edits/edits.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// The data that the changes of one pass are checked against. This holds references only.
struct AcceptanceRules {
  const Soup& input;
  /// Measures the distance from the input.
  const DeviationMeter& meter;
  double max_deviation = 0.0;
  /// The defects that the pass may create, because later passes repair them. Self-intersection
  /// stands for contact of faces that were cut apart, or doubled, and still coincide.
  DefectCodes may_create;
  /// See PlannedPass::must_mend.
  bool must_mend = false;
  /// The walls as DeviationMeter::measure() takes them, including those that these operations
  /// remove.
  std::span<const InteriorWall> walls = {};
  /// See DeviationMeter::Repaired::lost.
  std::span<const Index> lost = {};
  /// Tells whether the mesh before is known to be within the maximum deviation.
  bool was_within = false;
};

struct Acceptance {
  /// #operations: why each is rejected, or Rejection::None.
  std::vector<Rejection> rejections;

  [[nodiscard]] bool all_accepted() const;
};

/// Checks the effects of each operation of a list of edits on a mesh. Only this function decides
/// what an operation may not do.
///
/// If a violation cannot be attributed to any operation, all are rejected. Faces that no operation
/// affects are not checked, because they were accepted before.
[[nodiscard]] Acceptance check_acceptance(const RepairState& before, const RepairState& after,
                                          const AffectedElements& affected,
                                          std::size_t n_operations, const AcceptanceRules& rules);

}  // namespace meshalyzer
