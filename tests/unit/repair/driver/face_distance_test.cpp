#include "meshalyzer/repair/driver/internal/face_distance.h"

#include "meshalyzer/base/corners.h"
#include "meshalyzer/repair/driver/internal/searched_surface.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
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
      SurfaceDistance meter(surface.tree, surface.closest, bound, question, 0.0);
      EXPECT_FALSE(meter.measure(sliver).is_far) << bound;
    }
  }
}

/// A field of tents, 0.2 high.
Soup tents(Index size) {
  Soup field;
  for (Index i = 0; i <= size; ++i) {
    for (Index k = 0; k <= size; ++k) {
      field.positions.emplace_back(i, k, i % 2 == 0 && k % 2 == 0 ? 0.2 : 0.0);
    }
  }
  const auto at = [&](Index i, Index k) { return i * (size + 1) + k; };
  for (Index i = 0; i < size; ++i) {
    for (Index k = 0; k < size; ++k) {
      field.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      field.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return field;
}

/// Measures how far a triangle half-way up is, which needs pieces of its own for each tent.
FaceDistance measure_over_tents(Index size) {
  const double end = size;
  const Corners wide{Vec3(0, 0, 0.1), Vec3(end, 0, 0.1), Vec3(end, end, 0.1)};
  const SearchedSurface surface(tents(size));
  SurfaceDistance meter(surface.tree, surface.closest, 0.11, DistanceQuestion::HowFar, 0.0);
  return meter.measure(wide);
}

TEST(SurfaceDistance, FaceOverHundredsOfFacesIsMeasuredToTheResolution) {
  const FaceDistance distance = measure_over_tents(30);
  EXPECT_FALSE(distance.is_far);
  // It is farthest above the ground between the tents.
  EXPECT_GE(distance.largest, 0.1);
  EXPECT_LE(distance.largest, 0.1 + 0.11 * SurfaceDistance::kResolution);
}

TEST(SurfaceDistance, FaceOverThousandsOfFacesIsBounded) {
  const FaceDistance distance = measure_over_tents(100);
  EXPECT_FALSE(distance.is_far);
  EXPECT_GE(distance.largest, 0.1);
  EXPECT_LE(distance.largest, 0.11);
}

TEST(SurfaceDistance, WhatIsNearerThanAKnownDistanceIsOnlyBounded) {
  // A tilted triangle over a square: its distance is that of its highest corner.
  const SearchedSurface surface(
      shapes::make({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, {{0, 1, 2}, {0, 2, 3}}));
  const Corners tilted{Vec3(0, 0, 0.1), Vec3(3, 1, 0.1), Vec3(1, 2, 0.4)};
  const double resolution = SurfaceDistance::kResolution;
  for (const double known : {0.0, 0.2, 0.4, 0.7, 1.0}) {
    SurfaceDistance meter(surface.tree, surface.closest, 1.0, DistanceQuestion::HowFar, known);
    const FaceDistance distance = meter.measure(tilted);
    EXPECT_FALSE(distance.is_far) << known;
    EXPECT_GE(distance.largest, 0.4) << known;
    EXPECT_LE(distance.largest, std::max(0.4, known) + resolution) << known;
  }
}

}  // namespace
}  // namespace meshalyzer::test
