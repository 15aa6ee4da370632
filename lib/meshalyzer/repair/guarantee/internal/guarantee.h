#pragma once

#include "meshalyzer/repair/driver/internal/repair_driver.h"
#include "meshalyzer/repair/driver/options.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Replaces the parts that are still not good after a repair, until all of the mesh is good as the
/// file will hold it: sheets by thin solids, if a solid is asked for and nothing else is one; the
/// mesh by its union with itself; broken solids by a contour, each separately or all together. The
/// result is kept only if it is good and within the maximum deviation.
///
/// @return Sentences that say what was done, or why nothing was; none if the mesh was good.
[[nodiscard]] std::vector<std::string> guarantee_goodness(RepairDriver& driver,
                                                          const RepairOptions& options);

}  // namespace meshalyzer
