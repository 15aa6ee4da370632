#include "meshalyzer/repair/combine/internal/number_from_one.h"

namespace meshalyzer {

void number_from_one(TrackedMesh& mesh) {
  if (mesh.soup.format != Format::Mesh) return;
  mesh.soup.vertex_ids = {};
  mesh.soup.face_ids = {};
}

}  // namespace meshalyzer
