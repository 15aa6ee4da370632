#include "meshalyzer/repair/driver/internal/near_region.h"

#include "meshalyzer/base/triangle.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace meshalyzer {
namespace {

/// Of a triangle that leaves the plane, what is higher than this fraction of the distance has only
/// points of the plane near it that are near to the rest, too.
constexpr double kHighest = 0.7;

double largest_height(const ConvexPiece& piece, const FacePlane& plane) {
  double largest = 0.0;
  for (const Vec3& corner : piece.corners()) {
    largest = std::max(largest, std::abs(plane.height(corner)));
  }
  return largest;
}

/// Returns the part of a triangle between two parallels of a plane, one on either side.
ConvexPiece part_near_plane(const Corners& triangle, const FacePlane& plane, double height) {
  ConvexPiece part(triangle);
  for (const double side : {1.0, -1.0}) {
    part = part.cut({plane.point, side * plane.normal, height}).inside;
  }
  return part;
}

/// Returns the normal of a plane from whose side corners are seen counter-clockwise.
Vec3 turned_to(std::span<const Vec3> corners, const Vec3& normal) {
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    area += normal_of(corners[0], corners[i - 1], corners[i]);
  }
  return area.dot(normal) < 0.0 ? -normal : normal;
}

/// Returns the half-spaces that end at a distance beyond the sides of a polygon, which is projected
/// along a normal: from its tip the corners are seen counter-clockwise.
std::vector<HalfSpace> beyond_sides(std::span<const Vec3> corners, const Vec3& normal,
                                    double reach) {
  std::vector<HalfSpace> bounds;
  bounds.reserve(2 * corners.size());
  double longest = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 along = corners[(i + 1) % corners.size()] - corners[i];
    bounds.push_back({corners[i], along.cross(normal), reach});
    longest = std::max(longest, bounds.back().outward.stableNorm());
  }
  // The direction of a side that is projected to a point is a matter of rounding.
  constexpr double kShortest = 1e-10;
  std::erase_if(bounds, [&](const HalfSpace& side) {
    return !(side.outward.stableNorm() > kShortest * longest);
  });
  for (HalfSpace& side : bounds) side.outward.stableNormalize();
  return bounds;
}

/// Adds the half-spaces that cut off the corners of others, up to the points opposite the ends of
/// the sides: beyond these the polygon's corner is farther away than its sides.
void cut_off_corners(const Vec3& normal, std::vector<HalfSpace>& bounds) {
  const std::size_t n_sides = bounds.size();
  for (std::size_t i = 0; i < n_sides; ++i) {
    const HalfSpace& side = bounds[i];
    const Vec3& before = bounds[(i + n_sides - 1) % n_sides].outward;
    const Vec3 sum = before + side.outward;
    const double length = sum.norm();
    // The sides of a segment are opposite to each other, and the direction of its end is between.
    constexpr double kOpposite = 1e-8;
    const Vec3 outward =
        length > kOpposite ? Vec3(sum / length) : side.outward.cross(normal).normalized();
    bounds.push_back({side.point, outward, side.reach * length / 2.0});
  }
}

}  // namespace

std::vector<HalfSpace> find_near_region(const Corners& triangle, const FacePlane& plane,
                                        double distance, double height) {
  ConvexPiece part(triangle);
  double highest = largest_height(part, plane);
  if (highest > kHighest * distance) {
    highest = std::max(kHighest * distance, (std::abs(height) + distance) / 2.0);
    part = part_near_plane(triangle, plane, highest);
  }
  // Points of the plane that are so near to the projected part are within the distance of it.
  const double reach = std::sqrt(distance - highest) * std::sqrt(distance + highest);
  const Vec3 normal = turned_to(part.corners(), plane.normal);
  std::vector<HalfSpace> bounds = beyond_sides(part.corners(), normal, reach);
  cut_off_corners(normal, bounds);
  return bounds;
}

}  // namespace meshalyzer
