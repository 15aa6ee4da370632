#pragma once

#include "meshalyzer/defects/tolerances.h"
#include "meshalyzer/repair/driver/internal/repair_driver.h"
#include "meshalyzer/repair/driver/options.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Replaces what a repair has left that is not good, until all of the mesh is, as the file will
/// hold it: sheets by thin solids, where a solid is asked for and nothing else is one; broken
/// solids by a contour, each for itself or all together. What comes of it is kept only where it is
/// good and within the maximum deviation.
///
/// @return What was done, or why nothing was, in sentences; none where the mesh was good.
[[nodiscard]] std::vector<std::string> guarantee_goodness(RepairDriver& driver,
                                                          const RepairOptions& options,
                                                          const Tolerances& tolerances);

}  // namespace meshalyzer
