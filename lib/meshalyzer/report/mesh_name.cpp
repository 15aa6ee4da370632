#include "meshalyzer/report/mesh_name.h"

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

}  // namespace meshalyzer
