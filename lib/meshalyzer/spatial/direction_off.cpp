#include "meshalyzer/spatial/direction_off.h"

#include "meshalyzer/spatial/triangle_distance.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

/// The nearest point is found in fewer iterations, but for rounding.
constexpr int kMostIterations = 100;

/// Returns the normal that has the smallest dot product with a vector.
const Vec3& farthest_against(const Vec3& way, const std::vector<Vec3>& normals) {
  return *std::min_element(normals.begin(), normals.end(),
                           [&](const Vec3& a, const Vec3& b) { return a.dot(way) < b.dot(way); });
}

/// A triangle whose corners are normals, and its point that is nearest to the origin.
struct NearestOfTriangle {
  Corners corners;
  TrianglePoint nearest;
};

/// Returns the nearest to the origin of the three triangles in which one corner is replaced.
NearestOfTriangle with_corner(const NearestOfTriangle& triangle, const Vec3& corner) {
  NearestOfTriangle best;
  for (std::size_t i = 0; i < 3; ++i) {
    Corners corners = triangle.corners;
    corners[i] = corner;
    const TrianglePoint nearest = closest_on_triangle(corners, Vec3::Zero());
    if (i == 0 || nearest.distance < best.nearest.distance) best = {corners, nearest};
  }
  return best;
}

}  // namespace

DirectionOff direction_off(const std::vector<Vec3>& normals) {
  const Vec3& first = normals.front();
  NearestOfTriangle triangle{{first, first, first}, {first, first.norm()}};
  for (int i = 0; i < kMostIterations; ++i) {
    const NearestOfTriangle next =
        with_corner(triangle, farthest_against(triangle.nearest.point, normals));
    // Where the normals surround the origin, no triangle is nearer in the end.
    if (!(next.nearest.distance < triangle.nearest.distance)) break;
    triangle = next;
  }
  if (!(triangle.nearest.distance > 0.0)) return {};
  const Vec3 direction = triangle.nearest.point / triangle.nearest.distance;
  return {direction, farthest_against(direction, normals).dot(direction)};
}

}  // namespace meshalyzer
