#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/passes.h"
#include "support/intersecting_pairs.h"
#include "support/run_pass.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

constexpr double kHeight = 1e-3;
constexpr ToleranceOptions kTolerances{.degeneracy = 1e-9, .slit = 1e-9, .height = kHeight};

enum class Ends : std::uint8_t { Closed, Open };

/// A pyramid on its tip. The middle vertex of a square in its base is dragged over an edge of the
/// square, and `gap` above the base: the face there lies turned over between two layers.
Soup pyramid_with_fold(double gap, Ends ends) {
  Soup soup;
  soup.positions = {{0.5, 0.5, gap}, {0, 0, 0},   {1, 0, 0},   {1, -1, 0},
                    {0, -1, 0},      {0.5, 2, 0}, {0.5, 0, -1}};
  soup.triangles = {{0, 3, 2}, {0, 2, 1}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}};
  if (ends == Ends::Open) return soup;
  for (const Triangle& t : {Triangle{2, 3, 6}, {5, 2, 6}, {1, 5, 6}, {4, 1, 6}, {3, 4, 6}}) {
    soup.triangles.push_back(t);
  }
  return soup;
}

std::size_t n_foldovers(const Soup& soup) {
  const PreparedMesh mesh(soup);
  return find_foldovers(mesh, resolve_tolerances(kTolerances, box_of(soup))).size();
}

PassRun lifted(const Soup& soup, const RepairLimits& limits) {
  return run_pass(soup, lift_foldovers, limits, kTolerances);
}

TEST(LiftFoldovers, LayersComeFartherApartThanTheHeightToleranceAndDoNotMeet) {
  for (const double gap : {1e-5, 1e-4, 2e-4}) {
    SCOPED_TRACE(gap);
    const Soup soup = pyramid_with_fold(gap, Ends::Closed);
    ASSERT_EQ(n_intersecting_pairs(soup), 0U);
    ASSERT_EQ(n_foldovers(soup), 1U);
    const PassRun run = lifted(soup, wide_limits(soup));
    EXPECT_EQ(run.operations, 1U);
    EXPECT_EQ(n_foldovers(run.tracked.soup), 0U);
    EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
    EXPECT_EQ(run.tracked.soup.triangles, soup.triangles);
    std::size_t n_moved = 0;
    for (Index v = 0; v < soup.n_vertices(); ++v) {
      const double distance = (run.tracked.soup.positions[v] - soup.positions[v]).norm();
      EXPECT_LE(distance, 4.0 * kHeight * (1 + 1e-9));
      n_moved += distance > 0.0 ? 1U : 0U;
    }
    EXPECT_EQ(n_moved, 1U);
  }
}

TEST(LiftFoldovers, NothingIsProposedWithoutFoldovers) {
  const Soup soup = pyramid_with_fold(0.5, Ends::Closed);
  EXPECT_EQ(lifted(soup, wide_limits(soup)).operations, 0U);
}

TEST(LiftFoldovers, SheetsAreLeft) {
  const Soup soup = pyramid_with_fold(1e-5, Ends::Open);
  ASSERT_EQ(n_foldovers(soup), 1U);
  EXPECT_EQ(lifted(soup, wide_limits(soup)).operations, 0U);
}

TEST(LiftFoldovers, FixedVerticesStay) {
  const Soup soup = pyramid_with_fold(1e-5, Ends::Closed);
  RepairLimits limits = wide_limits(soup);
  limits.fixed_vertices.assign(soup.n_vertices(), 1);
  EXPECT_EQ(lifted(soup, limits).operations, 0U);
}

TEST(LiftFoldovers, NothingMovesFartherThanTheMaximumDeviation) {
  const Soup soup = pyramid_with_fold(1e-5, Ends::Closed);
  RepairLimits limits = wide_limits(soup);
  limits.max_deviation = kHeight;
  EXPECT_EQ(lifted(soup, limits).operations, 0U);
}

}  // namespace
}  // namespace meshalyzer
