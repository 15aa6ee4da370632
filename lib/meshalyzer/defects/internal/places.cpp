#include "meshalyzer/defects/internal/places.h"

#include <algorithm>

namespace meshalyzer {

std::vector<Vec3> middle_of_face(const Soup& soup, Index face) {
  const Triangle& t = soup.triangles[face];
  const auto missing = std::count(t.begin(), t.end(), kNoIndex);
  if (missing == 3) return {};
  Vec3 middle = Vec3::Zero();
  for (const Index v : t) {
    if (v != kNoIndex) middle += soup.positions[v] / static_cast<double>(3 - missing);
  }
  return {middle};
}

}  // namespace meshalyzer
