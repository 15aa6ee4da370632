#pragma once

#include "meshalyzer/repair/driver/internal/repair_driver.h"

#include <string>

namespace meshalyzer {

/// Tells whether a mesh has more intersecting pairs than a repair handles
/// (RepairOptions::max_pairs). Its intersecting pairs must have been searched.
[[nodiscard]] bool has_too_many_pairs(const RepairDriver& driver);

/// Returns the reason why a mesh cannot be repaired at all; empty if it can. Its intersecting pairs
/// must have been searched.
[[nodiscard]] std::string reason_against_repair(const RepairDriver& driver);

/// Returns the reason why a defect is left that no pass has refused.
[[nodiscard]] std::string reason_of_defects_left(const RepairDriver& driver);

}  // namespace meshalyzer
