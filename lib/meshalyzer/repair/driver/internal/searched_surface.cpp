#include "meshalyzer/repair/driver/internal/searched_surface.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/faces_near.h"

#include <algorithm>
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

/// Returns some faces of a soup with their vertices, in the same order.
Soup extract_faces(const Soup& soup, const std::vector<Index>& faces) {
  Soup part;
  std::vector<Index> number(soup.n_vertices(), kNoIndex);
  for (const Index face : faces) {
    Triangle corners = soup.triangles[face];
    for (Index& v : corners) {
      if (number[v] == kNoIndex) {
        number[v] = static_cast<Index>(part.positions.size());
        part.positions.push_back(soup.positions[v]);
      }
      v = number[v];
    }
    part.triangles.push_back(corners);
  }
  return part;
}

}  // namespace

Soup part_within(const Soup& surface, std::span<const Corners> triangles, double distance) {
  std::vector<Box3> boxes(triangles.size());
  std::transform(triangles.begin(), triangles.end(), boxes.begin(),
                 [&](const Corners& triangle) { return box_within(triangle, distance); });
  return extract_faces(surface, find_faces_near(surface, boxes));
}

}  // namespace meshalyzer
