#pragma once

#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/boolean/combine_solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

namespace meshalyzer::test {

/// Turns a soup about an axis through the origin.
[[nodiscard]] inline Soup rotated(Soup soup, double angle, const Vec3& axis) {
  const Eigen::AngleAxisd turn(angle, axis.normalized());
  for (Vec3& p : soup.positions) p = turn * p;
  return soup;
}

[[nodiscard]] inline Soup combined(const std::vector<Soup>& meshes, const InsideRule& rule) {
  const Soup all = concatenate(meshes);
  const CombinedSolid solid = combine_solids(operands_of(all, meshes), rule);
  EXPECT_EQ(solid.outcome, CombineOutcome::Done);
  return as_soup(solid);
}

[[nodiscard]] inline Analysis analyzed(const Soup& soup) {
  AnalysisOptions options;
  options.judge_fitness = true;
  return analyze(soup, "combined.mesh", options);
}

[[nodiscard]] inline std::string verdict_on(const Soup& soup) {
  return verdict_text(*analyzed(soup).fitness);
}

[[nodiscard]] inline double volume_of(const Soup& soup) {
  return analyzed(soup).characteristics.volume.value.value();
}

/// Returns the corners of faces by position, each beginning with its lowest corner.
[[nodiscard]] inline std::multiset<std::array<std::array<double, 3>, 3>> places_of(
    const Soup& soup) {
  std::multiset<std::array<std::array<double, 3>, 3>> all;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    std::array<std::array<double, 3>, 3> corners{};
    const auto at = corners_of(soup, f);
    for (std::size_t k = 0; k < 3; ++k) corners[k] = {at[k].x(), at[k].y(), at[k].z()};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

}  // namespace meshalyzer::test
