#include "meshalyzer/contour/boundary_samples.h"

#include "support/shapes.h"
#include "support/triangles_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace meshalyzer {
namespace {

Soup without_top(Soup cube, double height) {
  std::erase_if(cube.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) { return cube.positions[v][2] == height; });
  });
  return cube;
}

TEST(SampleBoundary, LiesAllOverAClosedSurfaceWhicheverWayItPoints) {
  // A bar of 2 x 1/8 x 1/8.
  Soup bar = shapes::cube(2);
  for (Vec3& p : bar.positions) p = p.cwiseProduct(Vec3(1, 1.0 / 16, 1.0 / 16));
  for (const Soup& soup : {bar, shapes::flipped(bar)}) {
    const std::vector<Vec3> samples = sample_boundary(soup, test::triangles_of(soup), 1e-3);
    // At most 1/128 of the diagonal apart, in two dimensions.
    const double spacing = Vec3(2, 0.125, 0.125).norm() / 128;
    const double area = 4 * 2 * 0.125 + 2 * 0.125 * 0.125;
    EXPECT_GE(static_cast<double>(samples.size()), area / (spacing * spacing));
    for (const Vec3& p : samples) {
      const double off = std::min({p.minCoeff(), 2 - p[0], 0.125 - p[1], 0.125 - p[2]});
      EXPECT_NEAR(off, 0, 1e-12);
    }
  }
}

TEST(SampleBoundary, LeavesOutWallsInsideTheSolid) {
  const Soup inner = shapes::cube(1, {1, 1, 1});
  const Soup both = shapes::merged(shapes::cube(3), inner);
  EXPECT_TRUE(sample_boundary(both, test::triangles_of(inner), 1e-3).empty());
}

TEST(SampleBoundary, LeavesOutWhatIsNearAHole) {
  // A wall that ends in the middle of the opening has winding numbers of about a half there.
  const Soup open = without_top(shapes::cube(2), 2);
  const Soup wall = shapes::make({{0.9, 0.9, 1.9}, {1.1, 0.9, 1.9}, {1, 1.1, 1.9}}, {{0, 1, 2}});
  EXPECT_FALSE(sample_boundary(open, test::triangles_of(open), 1e-3).empty());
  EXPECT_TRUE(sample_boundary(open, test::triangles_of(wall), 1e-3).empty());
}

TEST(SampleBoundary, OfNothingIsNothing) {
  EXPECT_TRUE(sample_boundary(shapes::cube(), {}, 1e-3).empty());
}

}  // namespace
}  // namespace meshalyzer
