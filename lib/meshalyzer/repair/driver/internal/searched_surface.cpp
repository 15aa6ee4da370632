#include "meshalyzer/repair/driver/internal/searched_surface.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/faces_near.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace meshalyzer {

std::vector<Box3> boxes_within(std::vector<Box3> boxes, double distance) {
  // Distances are computed with errors that are some 2^-50 of the coordinates.
  constexpr double kBeyondRounding = 0x1p-40;
  for (Box3& box : boxes) {
    const double largest =
        std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    box = grown(box, distance * (1.0 + kBeyondRounding) + kBeyondRounding * largest);
  }
  return boxes;
}

Soup part_near(const Soup& surface, std::span<const Box3> boxes) {
  std::vector<Triangle> near;
  for (const Index face : find_faces_near(surface, boxes)) {
    near.push_back(surface.triangles[face]);
  }
  return compact_soup(surface.positions, std::move(near));
}

}  // namespace meshalyzer
