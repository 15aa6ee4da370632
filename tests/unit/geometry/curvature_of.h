#pragma once

#include "meshalyzer/geometry/curvature.h"
#include "meshalyzer/mesh/build.h"

namespace meshalyzer {

[[nodiscard]] inline Curvature curvature_of(const Soup& soup, VertexArea area = VertexArea::Mixed) {
  return measure_curvature(build(soup), area);
}

}  // namespace meshalyzer
