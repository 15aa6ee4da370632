#pragma once

#include "meshalyzer/base/types.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace meshalyzer {

/// Where random points lie: each kind is hard for another part of an exact predicate.
enum class Cloud {
  /// Uniform in [-1, 1]^3: what a filter must be sure of.
  Generic,
  /// Any finite bit patterns: all magnitudes at once.
  BitPatterns,
  /// Below the smallest normal number: nothing may be lost to underflow.
  Denormal,
  /// Of a size whose product of three, or of two, is the smallest number: rounding is all there is.
  TinyProducts3d,
  TinyProducts2d,
  /// Coordinates about 1e200, 1 and 1e-200: products overflow and underflow.
  Mixed,
  /// Of all magnitudes of float, some zero, as if the bytes of an STL file were shifted.
  Spread,
  /// Near the largest double: differences overflow.
  Huge,
  /// Whole numbers -2 ... 2: often coplanar, collinear or the same.
  Lattice,
  /// Multiples of 0.1 on the plane z = 0.3 x + 0.7 y but for rounding: coplanar but for the last
  /// bit.
  NearPlane,
  /// On the line through the origin and (0.1, 0.2, 0.7) but for rounding.
  NearLine,
};

inline constexpr Cloud kClouds[] = {Cloud::Generic,        Cloud::BitPatterns,    Cloud::Denormal,
                                    Cloud::TinyProducts3d, Cloud::TinyProducts2d, Cloud::Mixed,
                                    Cloud::Spread,         Cloud::Huge,           Cloud::Lattice,
                                    Cloud::NearPlane,      Cloud::NearLine};

/// Random points, the same from the same seed on every platform.
class RandomPoints {
 public:
  explicit RandomPoints(std::uint32_t seed) : random_(seed) {}

  Vec3 next(Cloud cloud) {
    if (cloud == Cloud::NearPlane) {
      const double x = 0.1 * whole(20);
      const double y = 0.1 * whole(20);
      return {x, y, 0.3 * x + 0.7 * y};
    }
    if (cloud == Cloud::NearLine) {
      const double t = whole(50);
      return {0.1 * t, 0.2 * t, 0.7 * t};
    }
    const double x = coordinate(cloud);
    const double y = coordinate(cloud);
    return {x, y, coordinate(cloud)};
  }

 private:
  /// A whole number -n ... n.
  double whole(std::uint64_t n) {
    return static_cast<double>(random_() % (2 * n + 1)) - static_cast<double>(n);
  }

  double uniform() { return std::ldexp(static_cast<double>(random_() >> 10U), -53) - 1.0; }

  double coordinate(Cloud cloud) {
    constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63U;
    constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52U) - 1;
    switch (cloud) {
      case Cloud::BitPatterns:
        for (;;) {
          const auto value = std::bit_cast<double>(random_());
          if (std::isfinite(value)) return value;
        }
      case Cloud::Denormal:
        return std::bit_cast<double>(random_() & (kSignBit | kFraction));
      case Cloud::TinyProducts3d:
        return std::ldexp(uniform(), -1074 / 3);
      case Cloud::TinyProducts2d:
        return std::ldexp(uniform(), -1074 / 2);
      case Cloud::Mixed:
        return uniform() * std::pow(1e200, whole(1));
      case Cloud::Spread:
        return random_() % 8 == 0 ? 0.0 : std::ldexp(uniform(), static_cast<int>(whole(126)));
      case Cloud::Huge:
        return uniform() * 1.7e308;
      case Cloud::Lattice:
        return whole(2);
      default:
        return uniform();
    }
  }

  std::mt19937_64 random_;
};

}  // namespace meshalyzer
