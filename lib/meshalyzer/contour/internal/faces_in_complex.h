#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/soup.h"

#include <vector>

namespace meshalyzer {

/// Returns the corners of the faces of a soup that are in its complex, in their order.
[[nodiscard]] inline std::vector<Corners> faces_in_complex(const Soup& soup) {
  std::vector<Corners> faces;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (is_in_complex(soup.triangles[f])) faces.push_back(corners_of(soup, f));
  }
  return faces;
}

}  // namespace meshalyzer
