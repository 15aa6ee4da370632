#pragma once

#include "meshalyzer/repair/driver/internal/operation_names.h"
#include "meshalyzer/repair/driver/internal/plan.h"
#include "meshalyzer/repair/driver/repair_log.h"

#include <span>

namespace meshalyzer {

/// Adds to the log the defects that a pass has refused to repair.
void log_refusals(const PlannedPass& pass, std::span<const Refusal> refused,
                  const TrackedMesh& tracked, RepairLog& log);

/// Adds to the log an operation of a pass that was not accepted.
void log_rejection(const PlannedPass& pass, const OperationSignature& signature,
                   Rejection rejection, RepairLog& log);

}  // namespace meshalyzer
