#include "meshalyzer/boolean/internal/padded_operands.h"

#include "meshalyzer/boolean/combine_solids.h"
#include "support/boolean_results.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace meshalyzer {
namespace {

using test::verdict_on;
using test::volume_of;

Operands only(const Soup& soup) {
  return {soup, std::vector<Index>(soup.n_faces(), 0), 1};
}

std::vector<Index> all_faces(const Soup& soup) {
  std::vector<Index> faces(soup.n_faces());
  std::iota(faces.begin(), faces.end(), Index{0});
  return faces;
}

/// The volume of a regular tetrahedron whose corners are at a distance from its middle.
double volume_of_tetrahedron(double distance) {
  return 8.0 * std::sqrt(3.0) / 27.0 * std::pow(distance, 3);
}

TEST(PaddedOperands, PadOfACubeHasItsFacesInTheMiddle) {
  const Soup cube = shapes::cube(2);
  const Soup block = shapes::cube(4, {-1, -1, -1});
  PaddedOperands padded(only(block));
  padded.add_pad(cube, all_faces(cube), 0.125);
  const std::vector<double> volumes = volumes_of(padded.operands());
  ASSERT_EQ(volumes.size(), 3U);
  EXPECT_DOUBLE_EQ(volumes[0], 64.0);
  EXPECT_NEAR(volumes[1], std::pow(2.25, 3) - std::pow(2 - 2 * 0.3 * 0.125, 3), 1e-12);
  EXPECT_EQ(volumes[2], 0.0);
}

TEST(PaddedOperands, PadOfOneFaceEndsAtTheVerticesRoundIt) {
  const Soup sphere = shapes::icosphere(2);
  const Soup block = shapes::cube(4, {-2, -2, -2});
  PaddedOperands padded(only(block));
  padded.add_pad(sphere, std::vector<Index>{5}, 0.01);
  const CombinedSolid solid = combine_solids(padded.operands(), PaddedOperands::rule());
  const Soup left = as_soup(solid);
  EXPECT_EQ(verdict_on(left), "good");
  EXPECT_NEAR(volume_of(left), 64.0 - volumes_of(padded.operands())[1], 1e-12);
  EXPECT_GT(volumes_of(padded.operands())[1], 0.0);
}

TEST(PaddedOperands, CornersOfAThinBladeGetTetrahedra) {
  const Soup blade = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1e-5}},
                                  {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  PaddedOperands padded(only(shapes::cube(4, {-2, -2, -2})));
  padded.add_pad(blade, std::vector<Index>{0}, 0.01);
  // The fourth vertex is not one of the face, so it has none.
  EXPECT_NEAR(volumes_of(padded.operands())[2], 3 * volume_of_tetrahedron(0.04), 1e-15);
}

}  // namespace
}  // namespace meshalyzer
