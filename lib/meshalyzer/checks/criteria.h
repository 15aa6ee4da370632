#pragma once

#include "meshalyzer/checks/limits.h"
#include "meshalyzer/defects/defect.h"
#include "meshalyzer/defects/tolerances.h"

#include <cstddef>

namespace meshalyzer {

/// What a mesh must be to pass a check, and how much is told of one that is not.
struct CheckCriteria {
  /// The mesh must have none of these defects.
  DefectCodes codes;
  ToleranceOptions tolerances;
  Limits limits;
  /// At most this many findings of a code are listed; 0 lists all. Counts are complete all the
  /// same.
  std::size_t max_listed = 5;
  /// A file has so many lines in a report at most: where it would have more, fewer of each code are
  /// listed. 0: no limit, as where somebody says how many of a code are to be listed.
  std::size_t max_lines = 29;
  /// The search for intersecting pairs ends when it has found so many; counts that it concerns are
  /// "at least" then.
  std::size_t max_pairs = 10'000;
};

}  // namespace meshalyzer
