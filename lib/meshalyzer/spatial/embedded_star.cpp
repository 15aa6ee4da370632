#include "meshalyzer/spatial/embedded_star.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace meshalyzer {
namespace {

constexpr double kDoubleUnit = 0x1p-53;

// The error bound of the dot product of an exact direction and the cross product of two arms,
// relative to the product of their largest coordinates: 6 products of three numbers undergo 7
// roundings each, two in the arms, two products, a difference, two sums. The factor also covers the
// roundings of the bound itself.
constexpr double kFacingBound = 6 * 8 * kDoubleUnit * 1.01;

// The error bound of the dot product of an exact vector and one arm: 3 products with 4 roundings
// each.
constexpr double kSideBound = 3 * 4 * kDoubleUnit * 1.01;

// Within these magnitudes nothing overflows, and any underflow is far below the bounds.
constexpr double kSmall = 1e-270;
constexpr double kLarge = 1e70;

/// Directions have whole coordinates up to this, so that their sums and products below are exact.
constexpr double kFinest = 0x1p20;

/// An arbitrary direction that is unlikely to occur among the edges of a mesh; a plane through it
/// separates above from below.
const Vec3 kOddDirection(419.0, -281.0, 733.0);

/// Three coordinates that stay in registers. A product of vectors is written to memory in parts
/// and read as a whole, for which processors wait longer than it takes to compute.
struct Coordinates {
  double x;
  double y;
  double z;
};

Coordinates cross_product_of_arms(const Arm& a, const Arm& b) {
  const Vec3& u = a.vector;
  const Vec3& v = b.vector;
  return {u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(),
          u.x() * v.y() - u.y() * v.x()};
}

double largest(const Vec3& v) {
  return std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
}

/// What a face counts for in a mean of normals.
enum class Weight : std::uint8_t { Area, One };

/// Returns the mean direction of the faces' normals, in whole numbers.
std::optional<Vec3> facing_direction(const Star& star, Weight weight) {
  Coordinates all{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < star.n_faces(); ++i) {
    const auto [x, y, z] = cross_product_of_arms(star.first_arm(i), star.second_arm(i));
    double factor = 1.0;
    if (weight == Weight::One) {
      const double squared_length = x * x + y * y + z * z;
      if (squared_length == 0.0) {
        return std::nullopt;
      }
      factor = 1.0 / std::sqrt(squared_length);
    }
    all = {all.x + factor * x, all.y + factor * y, all.z + factor * z};
  }
  const Vec3 sum(all.x, all.y, all.z);
  const double length = largest(sum);
  // Normals that overflow have no direction; their sum is infinite or NaN.
  if (!(length > 0.0) || !sum.allFinite()) {
    return std::nullopt;
  }
  const auto whole = [&](double x) {
    return static_cast<double>(static_cast<int>(x / length * kFinest));
  };
  return Vec3(whole(sum.x()), whole(sum.y()), whole(sum.z()));
}

bool all_surely_face(const Star& star, const Vec3& direction) {
  const double bound = kFacingBound * largest(direction);
  for (std::size_t i = 0; i < star.n_faces(); ++i) {
    const Arm& u = star.first_arm(i);
    const Arm& v = star.second_arm(i);
    const auto [x, y, z] = cross_product_of_arms(u, v);
    const double facing = direction.x() * x + direction.y() * y + direction.z() * z;
    const double area = u.size * v.size;
    const bool is_sure = facing > bound * area && area > kSmall;
    if (!is_sure) {
      return false;
    }
  }
  return true;
}

/// The number of times that the arms, in their order, change from one side of a plane through the
/// hub to the other.
struct Crossings {
  int up = 0;
  int down = 0;
};

/// @param normal  The exact normal of the plane.
/// @return Nothing if an arm is not surely on one side.
std::optional<Crossings> count_crossings(const Star& star, const Vec3& normal) {
  const double bound = kSideBound * largest(normal);
  const auto is_sure = [&](double height, const Arm& arm) {
    return std::abs(height) > bound * arm.size && arm.size > kSmall;
  };
  const double first = normal.dot(star.arms.front().vector);
  if (!is_sure(first, star.arms.front())) {
    return std::nullopt;
  }
  Crossings crossings;
  bool is_above = first > 0.0;
  const auto go_to = [&](bool above) {
    crossings.up += static_cast<int>(above && !is_above);
    crossings.down += static_cast<int>(!above && is_above);
    is_above = above;
  };
  for (const Arm& arm : star.arms.subspan(1)) {
    const double height = normal.dot(arm.vector);
    if (!is_sure(height, arm)) {
      return std::nullopt;
    }
    go_to(height > 0.0);
  }
  if (star.is_closed) {
    go_to(first > 0.0);
  }
  return crossings;
}

bool has_small_arms(const Star& star) {
  return std::all_of(star.arms.begin(), star.arms.end(),
                     [](const Arm& arm) { return arm.size < kLarge; });
}

/// Tells whether the test succeeds with a direction, if there is one.
bool is_surely_embedded_along(const std::optional<Vec3>& direction, const Star& star) {
  if (!direction || !all_surely_face(star, *direction)) {
    return false;
  }
  // This plane contains the direction and appears as a line through the hub when seen along it. A
  // sector is less than half a turn, so each turn crosses each half of that line once, one upwards
  // and one downwards.
  const Vec3 normal = direction->cross(kOddDirection);
  const std::optional<Crossings> crossings = count_crossings(star, normal);
  if (!crossings) {
    return false;
  }
  return star.is_closed ? crossings->up == 1 : crossings->up == 0 || crossings->down == 0;
}

}  // namespace

bool is_surely_embedded(const Star& star) {
  if (star.n_faces() == 0 || !has_small_arms(star)) {
    return false;
  }
  // Weights of areas need no square roots, and are as good unless the areas differ much.
  return is_surely_embedded_along(facing_direction(star, Weight::Area), star) ||
         is_surely_embedded_along(facing_direction(star, Weight::One), star);
}

}  // namespace meshalyzer
