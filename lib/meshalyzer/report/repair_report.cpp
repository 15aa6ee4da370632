#include "meshalyzer/report/repair_report.h"

#include <utility>

namespace meshalyzer {

MeshName name_of(const Soup& soup, std::string path) {
  return {.path = std::move(path),
          .format = soup.format,
          .vertex_ids = soup.vertex_ids,
          .face_ids = soup.face_ids,
          .n_vertices = soup.n_vertices(),
          .n_faces = soup.n_faces()};
}

std::size_t n_asked(const DefectReport& report, const DefectCodes& asked) {
  std::size_t n = 0;
  for (const DefectCode code : all_defect_codes()) {
    if (asked.contains(code)) n += report.count(code);
  }
  return n;
}

std::size_t n_remaining(const RepairReport& report) {
  std::size_t n = 0;
  for (const FinalMesh& mesh : report.meshes) n += n_asked(mesh.remaining, report.fixes);
  return n;
}

}  // namespace meshalyzer
