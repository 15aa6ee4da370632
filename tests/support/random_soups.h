#pragma once

#include "meshalyzer/mesh/soup.h"

#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {

/// Returns an integer below n. It does not use std::uniform_int_distribution, which differs between
/// libraries.
[[nodiscard]] inline Index below(std::mt19937& random, Index n) {
  return static_cast<Index>(random() % n);
}

/// Returns a number between two others.
[[nodiscard]] inline double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 0x1p32;
}

/// Returns one of the coordinates 0, 1, ..., n - 1, so that points are often collinear or the same.
[[nodiscard]] inline double lattice(std::mt19937& random, int n) {
  return static_cast<double>(std::uniform_int_distribution<>(0, n - 1)(random));
}

/// Returns a surface in which about one of `rarity` faces was lost, one repeated and one turned
/// over.
[[nodiscard]] inline Soup damaged(Soup soup, Index rarity, std::mt19937& random) {
  std::vector<Triangle> kept;
  for (Triangle t : soup.triangles) {
    if (below(random, rarity) == 0) continue;
    if (below(random, rarity) == 0) kept.push_back(t);
    if (below(random, rarity) == 0) std::swap(t[0], t[1]);
    kept.push_back(t);
  }
  soup.triangles = std::move(kept);
  return soup;
}

}  // namespace meshalyzer
