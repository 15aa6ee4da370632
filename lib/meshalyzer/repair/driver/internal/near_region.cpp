#include "meshalyzer/repair/driver/internal/near_region.h"

#include "meshalyzer/base/triangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace meshalyzer {
namespace {

/// Returns the other leg of a right triangle.
double leg(double hypotenuse, double other) {
  return std::sqrt(hypotenuse - other) * std::sqrt(hypotenuse + other);
}

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
  bounds.reserve(2 * corners.size() + 1);
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

/// Adds a half-space that ends at the line between two points at a distance from a corner.
///
/// @param first, second  The directions of the points, of length 1.
/// @param half_way       The direction half-way if they are opposite.
void add_chord(const Vec3& corner, double reach, const Vec3& first, const Vec3& second,
               const Vec3& half_way, std::vector<HalfSpace>& bounds) {
  constexpr double kOpposite = 1e-8;
  const Vec3 sum = first + second;
  const double length = sum.norm();
  bounds.push_back(
      {corner, length > kOpposite ? Vec3(sum / length) : half_way, reach * length / 2.0});
}

/// Adds the half-spaces that cut off the corners of others, between the points opposite the ends of
/// the sides: beyond these the polygon's corner is farther away than its sides. Where a place lies
/// outward from a corner, they leave it a tip.
void cut_off_corners(const Vec3& normal, const Vec3& place, std::vector<HalfSpace>& bounds) {
  const std::size_t n_sides = bounds.size();
  for (std::size_t i = 0; i < n_sides; ++i) {
    const HalfSpace side = bounds[i];
    const Vec3 before = bounds[(i + n_sides - 1) % n_sides].outward;
    const Vec3 backwards = side.outward.cross(normal);
    Vec3 to_place = place - side.point;
    to_place -= to_place.dot(normal) * normal;
    const bool is_outward =
        before.cross(to_place).dot(normal) > 0.0 && to_place.cross(side.outward).dot(normal) > 0.0;
    if (is_outward) {
      to_place.stableNormalize();
      add_chord(side.point, side.reach, before, to_place, to_place, bounds);
      add_chord(side.point, side.reach, to_place, side.outward, to_place, bounds);
    } else {
      add_chord(side.point, side.reach, before, side.outward, backwards, bounds);
    }
  }
}

}  // namespace

std::vector<HalfSpace> find_near_region(const Corners& triangle, const FacePlane& plane,
                                        double distance, const PlaceNearTriangle& from) {
  const double of_place = (from.place - from.closest).stableNorm();
  if (!(of_place < distance)) return {};
  // Where the triangle leaves the plane, only the part of it up to this height counts: the lower
  // the part, the farther the region reaches beyond its sides. It has to reach beyond the place.
  const double rest = leg(distance, of_place) / std::numbers::sqrt2;
  const double most = std::hypot(plane.height(from.closest), rest);
  ConvexPiece part(triangle);
  double highest = largest_height(part, plane);
  if (highest > most) {
    highest = most;
    part = part_near_plane(triangle, plane, most);
  }
  // Points of the plane that are so near to the projected part are within the distance of it.
  const double reach = leg(distance, highest);
  const Vec3 normal = turned_to(part.corners(), plane.normal);
  std::vector<HalfSpace> bounds = beyond_sides(part.corners(), normal, reach);
  cut_off_corners(normal, from.place, bounds);
  return bounds;
}

}  // namespace meshalyzer
