#pragma once

#include "meshalyzer/defects/find_defects.h"
#include "meshalyzer/repair/driver/internal/repair_driver.h"
#include "meshalyzer/repair/driver/patch_outcome.h"

#include <vector>

namespace meshalyzer {

/// Determines the outcome of the repair for each patch of intersecting faces.
///
/// @param before  The defects of the driver's input.
/// @return        One for each self-intersection that is listed, in their order.
/// @complexity    O(#F), and the cost of DeviationMeter::measure_parts().
[[nodiscard]] std::vector<PatchOutcome> find_patch_outcomes(const RepairDriver& driver,
                                                            const DefectReport& before);

}  // namespace meshalyzer
