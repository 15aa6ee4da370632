#include "meshalyzer/contour/contour_mesh.h"
#include "meshalyzer/repair/replace/internal/replacements.h"
#include "meshalyzer/repair/replace/internal/usable_contour.h"
#include "support/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

Replacement replace(const Soup& soup) {
  const TrackedMesh tracked = track_mesh(soup);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances;
  const RepairLimits limits{.max_deviation = 0.1, .fixed_vertices = {}};
  return replace_broken_solids({soup, tracked, mesh, tolerances, limits}, {.max_deviation = 0.1});
}

const Soup kCrossingCubes = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));

TEST(ReplaceBrokenSolids, EachIsReplaced) {
  const Soup soup = shapes::merged(kCrossingCubes, shapes::translated(kCrossingCubes, {9, 0, 0}));
  const Replacement replacement = replace(soup);
  EXPECT_EQ(replacement.result.edits.n_operations, 2U);
  EXPECT_TRUE(replacement.result.refused.empty());
  EXPECT_GT(replacement.deviation, 0.0);
  EXPECT_LE(replacement.deviation, 0.1);
}

TEST(ReplaceBrokenSolids, NoneIsReplacedIfOneCannotBe) {
  // Two triangles that cross bound no solid.
  const Soup sheets = shapes::make(
      {{9, 0, 0}, {10, 0, 0}, {9, 1, 0}, {9.2, 0.2, -1}, {9.4, 0.2, -1}, {9.3, 0.2, 1}},
      {{0, 1, 2}, {3, 4, 5}});
  for (const Soup& soup :
       {shapes::merged(kCrossingCubes, sheets), shapes::merged(sheets, kCrossingCubes)}) {
    const Replacement replacement = replace(soup);
    EXPECT_TRUE(replacement.result.edits.empty());
    EXPECT_EQ(replacement.result.refused.size(), 1U);
  }
}

TEST(ReplaceBrokenSolids, WhatHasCoordinatesTooLargeForAGridStays) {
  const Replacement replacement = replace(shapes::translated(kCrossingCubes, {1e15, 0, 0}));
  EXPECT_FALSE(replacement.needs_larger_grid);
  ASSERT_EQ(replacement.result.refused.size(), 1U);
  EXPECT_THAT(replacement.result.refused.front().reason, testing::HasSubstr("no grid"));
}

TEST(UsableContour, ReasonTellsWhatItLacks) {
  const auto reason = [](double max_deviation, const StopQuery& wants_to_stop) {
    const auto contour = contour_mesh(
        kCrossingCubes,
        {.max_deviation = max_deviation, .max_tetrahedra = 1000, .wants_to_stop = wants_to_stop});
    return reason_against(contour, wants_to_stop);
  };
  EXPECT_EQ(reason(0.1, {}), nullptr);
  EXPECT_THAT(reason(0.001, {}), testing::HasSubstr("needs a finer grid"));
  EXPECT_THAT(reason(0.1, [] { return true; }), testing::HasSubstr("no time"));
}

}  // namespace
}  // namespace meshalyzer
