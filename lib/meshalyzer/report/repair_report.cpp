#include "meshalyzer/report/repair_report.h"

#include <algorithm>

namespace meshalyzer {

std::size_t n_remaining(const RepairReport& report) {
  std::size_t n = 0;
  for (const FinalMesh& mesh : report.meshes) n += mesh.remaining.count(report.fixes);
  return n;
}

bool may_have_more(const RepairReport& report) {
  return std::any_of(report.meshes.begin(), report.meshes.end(), [&](const FinalMesh& mesh) {
    return mesh.remaining.may_have_more(report.fixes);
  });
}

bool nothing_remains(const RepairReport& report) {
  return n_remaining(report) == 0 && !may_have_more(report);
}

}  // namespace meshalyzer
