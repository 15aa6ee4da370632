#include "meshalyzer/repair/driver/internal/face_distance.h"

#include "meshalyzer/base/corners.h"
#include "meshalyzer/repair/driver/internal/searched_surface.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer::test {
namespace {

// Of this sliver the search came to pieces with all corners on a line, which it divided again and
// again into pieces as long as before, until it gave up and called the face far.
TEST(SurfaceDistance, SliverIsWithinEachBoundOfTheFacesThatItWasCutInto) {
  // The first three are the corners of the sliver.
  const std::vector<Vec3> positions = {{12, 16, -2},
                                       {-15, 8, -2},
                                       {-14.75, 8, -1.75},
                                       {-13.078125, 8.5, -1.765625},
                                       {-13.265625, 8.5, -1.953125},
                                       {-14.0078125, 8.25, -1.8515625},
                                       {6.9375, 14.5, -2},
                                       {-8.0625, 10, -1.8125},
                                       {5.25, 14, -2},
                                       {-9.9375, 9.5, -2},
                                       {3.1875, 13.375, -1.953125},
                                       {6, 14.21875, -1.98828125}};
  const Soup parts = shapes::make(positions, {{3, 4, 5},
                                              {0, 6, 7},
                                              {4, 1, 2},
                                              {8, 9, 7},
                                              {7, 4, 3},
                                              {3, 5, 2},
                                              {10, 8, 7},
                                              {11, 8, 10},
                                              {6, 8, 11},
                                              {9, 1, 7}});
  const Corners sliver{positions[0], positions[1], positions[2]};
  const SearchedSurface surface(parts);
  for (const double bound : {1.0, 0.02, 0.001}) {
    for (const auto question : {DistanceQuestion::IsWithin, DistanceQuestion::HowFar}) {
      SurfaceDistance meter(surface.tree, surface.closest, bound, question);
      EXPECT_FALSE(meter.measure(sliver).is_far) << bound;
    }
  }
}

}  // namespace
}  // namespace meshalyzer::test
