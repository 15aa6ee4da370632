#include "meshalyzer/report/repair_report.h"

namespace meshalyzer {

std::size_t n_remaining(const RepairReport& report) {
  std::size_t n = 0;
  for (const FinalMesh& mesh : report.meshes) n += mesh.remaining.count(report.fixes);
  return n;
}

}  // namespace meshalyzer
