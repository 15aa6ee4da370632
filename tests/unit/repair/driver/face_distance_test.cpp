#include "meshalyzer/repair/driver/internal/face_distance.h"

#include "meshalyzer/base/corners.h"
#include "meshalyzer/repair/driver/internal/searched_surface.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer::test {
namespace {

// Of this sliver the search came to pieces with all corners on a line, which it divided again and
// again into pieces as long as before, until it gave up and called the face far.
TEST(SurfaceDistance, SliverIsWithinEachBoundOfTheFacesThatItWasCutInto) {
  const Soup parts = shapes::make(
      {
          {-1, 11, -4},                            // 0, 1, 2: the corners of the sliver
          {-14, -7, 0},                            //
          {-13.75, -7.25, -0.25},                  //
          {-2.625, 8.75, -3.5},                    // 3 to 7: points of its long edges and inside
          {-4.25, 6.5, -3},                        //
          {-10.5625, -2.6875, -1.1875},            //
          {-3.12109375, 8.03515625, -3.35546875},  //
          {-4.609375, 5.890625, -2.921875},        //
          {-12.28125, -4.84375, -0.59375},         //
          {-12.15625, -4.96875, -0.71875},         //
      },
      {{9, 8, 2}, {0, 3, 5}, {4, 1, 5}, {7, 4, 5}, {8, 1, 2}, {6, 4, 7}, {5, 8, 9}, {3, 4, 6}});
  const Corners sliver{parts.positions[0], parts.positions[1], parts.positions[2]};
  const SearchedSurface surface(parts);
  for (const double bound : {1.0, 0.06, 0.004}) {
    for (const auto question : {DistanceQuestion::IsWithin, DistanceQuestion::HowFar}) {
      SurfaceDistance meter(surface.tree, surface.closest, bound, question);
      EXPECT_FALSE(meter.measure(sliver).is_far) << bound;
    }
  }
}

}  // namespace
}  // namespace meshalyzer::test
