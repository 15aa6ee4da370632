#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <string>

namespace meshalyzer {

/// The names of a mesh and of its elements in reports.
struct MeshName {
  /// The path of the file as the user named it.
  std::string path;
  Format format = Format::Mesh;
  Ids vertex_ids;
  Ids face_ids;
  std::size_t n_vertices = 0;
  std::size_t n_faces = 0;
};

/// Returns the name of a mesh and of its elements.
[[nodiscard]] MeshName name_of(const Soup& soup, std::string path);

}  // namespace meshalyzer
