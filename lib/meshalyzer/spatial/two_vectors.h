#pragma once

#include "meshalyzer/base/types.h"

namespace meshalyzer {

/// One number for each of two points.
using Two = Eigen::Array2d;

/// Two points, or the offsets of one place from two points, which processors compute at once.
struct TwoVectors {
  TwoVectors(const Vec3& first, const Vec3& second)
      : x(first.x(), second.x()), y(first.y(), second.y()), z(first.z(), second.z()) {}
  TwoVectors(const Two& x_values, const Two& y_values, const Two& z_values)
      : x(x_values), y(y_values), z(z_values) {}

  [[nodiscard]] TwoVectors from(const Vec3& place) const {
    return {place.x() - x, place.y() - y, place.z() - z};
  }
  [[nodiscard]] Two dot(const TwoVectors& other) const {
    return x * other.x + y * other.y + z * other.z;
  }
  [[nodiscard]] Two dot(const Vec3& other) const {
    return x * other.x() + y * other.y() + z * other.z();
  }
  [[nodiscard]] TwoVectors cross(const TwoVectors& other) const {
    return {y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x};
  }

  Two x;
  Two y;
  Two z;
};

}  // namespace meshalyzer
