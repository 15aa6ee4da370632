#include "meshalyzer/report/repair_report.h"

#include <algorithm>

namespace meshalyzer {
namespace {

template <typename Count>
std::size_t sum_over_meshes(const RepairReport& report, const Count& count) {
  std::size_t sum = 0;
  for (const FinalMesh& mesh : report.meshes) sum += count(mesh);
  return sum;
}

}  // namespace

std::size_t n_final_vertices(const RepairReport& report) {
  return sum_over_meshes(report, [](const FinalMesh& mesh) { return mesh.name.n_vertices; });
}

std::size_t n_final_faces(const RepairReport& report) {
  return sum_over_meshes(report, [](const FinalMesh& mesh) { return mesh.name.n_faces; });
}

std::size_t n_remaining(const RepairReport& report, const DefectCodes& codes) {
  return sum_over_meshes(report,
                         [&](const FinalMesh& mesh) { return mesh.remaining.count(codes); });
}

std::size_t n_remaining(const RepairReport& report) {
  return n_remaining(report, report.fixes);
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
