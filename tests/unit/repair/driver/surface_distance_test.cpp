#include "support/surface_distance.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meshalyzer::test {
namespace {

TEST(SampledDistance, RaisedPlaneIsAsFarAsItWasRaised) {
  const Soup plane = shapes::grid(5, 4);
  const Soup raised = shapes::translated(shapes::grid(3, 3), {0.6, 0.4, 0.25});
  EXPECT_NEAR(sampled_distance(raised, plane, 0.1), 0.25, 1e-14);
  // The corner (5, 4) is (1.4, 0.6) beyond the other's end.
  EXPECT_NEAR(sampled_distance(plane, raised, 0.1), std::hypot(1.4, 0.6, 0.25), 1e-14);
}

TEST(SampledDistance, IsBetweenTheTrueDistanceAndASpacingLess) {
  // The point of the cube's top farthest from its rim: the middle, 1/2 away.
  const Soup cube = shapes::cube();
  const double sampled = sampled_distance(cube, shapes::open_cube(), 0.07);
  EXPECT_LE(sampled, 0.5);
  EXPECT_GE(sampled, 0.5 - 0.07);
}

TEST(SampledDistance, OfAFaceIsTheLeastOfThoseFromEachFaceAlone) {
  // Points seen from inside, near and far: the grid must not miss the nearest face.
  const Soup torus = shapes::torus(1, 0.4, 24, 12);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0.1, 0), Vec3(0.3, 4, 0.1), Vec3(-30, 9, 7)}) {
    const Soup point = shapes::make({p, p, p}, {{0, 1, 2}});
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& other : torus.triangles) {
      const Soup face = shapes::make(torus.positions, {other});
      least = std::min(least, sampled_distance(point, face, 1.0));
    }
    EXPECT_EQ(sampled_distance(point, torus, 1.0), least);
  }
}

TEST(SampledDistance, FaceOfZeroAreaIsItsSegment) {
  const Soup segment = shapes::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  EXPECT_NEAR(sampled_distance(shapes::translated(segment, {1, 1, 0}), segment, 0.5),
              std::sqrt(2.0), 1e-14);
}

TEST(SampledDistance, OfNothingIsZeroAndFromNothingInfinite) {
  const Soup nothing = shapes::make({{0, 0, 0}}, {{0, 0, 0}});
  EXPECT_EQ(sampled_distance(nothing, shapes::cube(), 1.0), 0.0);
  EXPECT_EQ(sampled_distance(shapes::cube(), nothing, 1.0),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace meshalyzer::test
