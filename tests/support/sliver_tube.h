#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace meshalyzer::test {

/// Returns a closed tube of n sides along a diagonal of space, with faces much longer than wide.
inline Soup sliver_tube(std::size_t n, const Vec3& along) {
  Soup soup;
  const Vec3 u = along.unitOrthogonal();
  const Vec3 v = along.normalized().cross(u);
  for (std::size_t end = 0; end < 2; ++end) {
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      soup.positions.push_back(along * static_cast<double>(end) + std::cos(angle) * u +
                               std::sin(angle) * v);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto a = static_cast<Index>(i);
    const auto b = static_cast<Index>((i + 1) % n);
    const auto m = static_cast<Index>(n);
    soup.triangles.push_back({a, b, b + m});
    soup.triangles.push_back({a, b + m, a + m});
  }
  return soup;
}

}  // namespace meshalyzer::test
