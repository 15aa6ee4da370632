#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"

#include <cstddef>

namespace meshalyzer {

[[nodiscard]] inline std::size_t n_intersecting_pairs(const Soup& soup) {
  return PreparedMesh(soup).intersecting_pairs().size();
}

}  // namespace meshalyzer
