#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/soup.h"

#include <vector>

namespace meshalyzer::test {

/// Returns the corners of each face.
[[nodiscard]] inline std::vector<Corners> triangles_of(const Soup& soup) {
  std::vector<Corners> corners;
  for (const Triangle& t : soup.triangles) {
    corners.push_back({soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]});
  }
  return corners;
}

}  // namespace meshalyzer::test
