#include "meshalyzer/repair/driver/internal/searched_surface.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/faces_near.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns a box round all points within a distance of a triangle.
Box3 box_within(const Corners& triangle, double distance) {
  // Distances are computed with errors that are some 2^-50 of the coordinates.
  constexpr double kBeyondRounding = 0x1p-40;
  Box3 box = box_of(triangle);
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double margin = distance * (1.0 + kBeyondRounding) + kBeyondRounding * largest;
  box.min().array() -= margin;
  box.max().array() += margin;
  return box;
}

}  // namespace

std::vector<Box3> boxes_within(std::span<const Corners> triangles, double distance) {
  std::vector<Box3> boxes(triangles.size());
  std::transform(triangles.begin(), triangles.end(), boxes.begin(),
                 [&](const Corners& triangle) { return box_within(triangle, distance); });
  return boxes;
}

std::vector<Index> faces_within(const Soup& surface, std::span<const Corners> triangles,
                                double distance) {
  return find_faces_near(surface, boxes_within(triangles, distance));
}

Soup part_within(const Soup& surface, std::span<const Corners> triangles, double distance) {
  std::vector<Triangle> near;
  for (const Index face : faces_within(surface, triangles, distance)) {
    near.push_back(surface.triangles[face]);
  }
  return compact_soup(surface.positions, std::move(near));
}

}  // namespace meshalyzer
