#pragma once

#include "meshalyzer/checks/limits.h"
#include "meshalyzer/defects/defect.h"
#include "meshalyzer/defects/tolerances.h"

#include <cstddef>

namespace meshalyzer {

/// The criteria that a mesh must meet to pass a check, and the limits of the report.
struct CheckCriteria {
  /// The mesh must have none of these defects.
  DefectCodes codes;
  ToleranceOptions tolerances;
  Limits limits;
  /// At most this many findings of a code are listed; 0 lists all. Counts are complete in any case.
  std::size_t max_listed = 5;
  /// The largest number of lines of a file in a report: if it would have more, fewer findings of
  /// each code are listed. 0 means no limit, which also applies if the user sets max_listed.
  std::size_t max_lines = 29;
  /// The search for intersecting pairs ends when it has found this many; the counts that depend on
  /// it are then lower bounds.
  std::size_t max_pairs = 10'000;
};

}  // namespace meshalyzer
