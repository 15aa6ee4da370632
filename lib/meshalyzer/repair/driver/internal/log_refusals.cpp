#include "meshalyzer/repair/driver/internal/log_refusals.h"

namespace meshalyzer {

void log_refusals(const PlannedPass& pass, std::span<const Refusal> refused,
                  const TrackedMesh& tracked, RepairLog& log) {
  for (const Refusal& refusal : refused) {
    LoggedRefusal& logged = log.refusals.emplace_back();
    logged.pass = pass.name;
    logged.code = refusal.code;
    logged.vertex = refusal.vertex == kNoIndex ? kNoIndex : tracked.vertex_keys[refusal.vertex];
    logged.face = refusal.face == kNoIndex ? kNoIndex : tracked.face_keys[refusal.face];
    logged.reason = refusal.reason;
    logged.rejection = refusal.rejection;
  }
}

void log_rejection(const PlannedPass& pass, const OperationSignature& signature,
                   Rejection rejection, RepairLog& log) {
  LoggedRefusal& logged = log.refusals.emplace_back();
  logged.pass = pass.name;
  logged.code = pass.code;
  if (signature.size() > 1 && signature.front() == kNoIndex) {
    logged.vertex = signature[1];
  } else if (!signature.empty()) {
    logged.face = signature.front();
  }
  logged.reason = rejection_reason(rejection);
  logged.rejection = rejection;
}

}  // namespace meshalyzer
