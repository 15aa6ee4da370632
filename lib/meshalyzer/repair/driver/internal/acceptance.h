#pragma once

#include "meshalyzer/defects/defect.h"
#include "meshalyzer/repair/driver/deviation.h"
#include "meshalyzer/repair/driver/internal/repair_state.h"
#include "meshalyzer/repair/driver/rejection.h"
#include "meshalyzer/repair/edits/edits.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// What the changes of one pass are checked against. This holds references only.
struct AcceptanceRules {
  const Soup& input;
  /// Measures the distance from the input.
  const DeviationMeter& meter;
  double max_deviation = 0.0;
  /// Defects that the pass may create, for later passes to repair. Self-intersection stands for
  /// contact of faces that were cut apart and still coincide.
  DefectCodes may_create;
  /// See DeviationMeter::measure(); those that these operations take away are among them.
  std::span<const InteriorWall> walls = {};
};

struct Acceptance {
  /// #operations.
  std::vector<Rejection> rejections;

  [[nodiscard]] bool all_accepted() const;
};

/// Checks what each operation of a list of edits has done to a mesh. This is the one place that
/// decides what an operation may not do.
///
/// Where a violation cannot be attributed to any operation, all are rejected. Faces that no
/// operation affects are not checked: they were accepted before.
[[nodiscard]] Acceptance check_acceptance(const RepairState& before, const RepairState& after,
                                          const AffectedElements& affected,
                                          std::size_t n_operations, const AcceptanceRules& rules);

}  // namespace meshalyzer
