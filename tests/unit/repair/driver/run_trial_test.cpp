#include "meshalyzer/repair/driver/internal/repair_driver.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

/// Trials on a cube with passes that move its first corner. Once the x of that is negative, the
/// second corner must stay in place.
class RunTrial : public ::testing::Test {
 protected:
  /// Returns a pass that moves the first corner to a place beside that in the input.
  PlannedPass move(std::string_view name, const Vec3& by) {
    const auto run = [this, by](const PassInput& input) {
      ++n_runs_;
      PassResult result;
      const Vec3& from = input.tracked.soup.positions[0];
      const Vec3 to = input.original.positions[0] + by;
      if (from == to) return result;
      const Index op = result.edits.begin_operation();
      result.edits.moved_vertices.push_back({.op = op, .vertex = 0, .to = to});
      return result;
    };
    return {.name = name, .run = run};
  }

  /// Tries a change that is not wanted, from the input with its first corner moved.
  ///
  /// @return The position of the corner before the change.
  Vec3 position_after_start(std::string_view name, const Vec3& by) {
    Vec3 position = Vec3::Zero();
    const PlannedPass look{
        .name = "look", .run = [&](const PassInput& input) {
          position = input.tracked.soup.positions[0];
          seen_.push_back(input.limits.fixed_vertices);
          PassResult result;
          result.edits.removed_faces.push_back({.op = result.edits.begin_operation(), .face = 0});
          return result;
        }};
    EXPECT_FALSE(driver_.run_trial({.from_input = {move(name, by)},
                                    .changes = {look},
                                    .plan = {},
                                    .is_wanted = [](const RepairState&) { return false; }}));
    return position;
  }

  std::size_t n_runs_ = 0;
  /// The fixed vertices that the changes of each trial got.
  std::vector<std::vector<std::uint8_t>> seen_;
  Soup cube_ = shapes::cube(1);
  RepairDriver driver_{cube_,
                       {},
                       RepairLimits{.max_deviation = 1.0, .fixed_vertices = {}},
                       [](const TrackedMesh& tracked, const CutMesh&) {
                         const bool is_moved = tracked.soup.positions[0].x() < 0.0;
                         return std::vector<std::uint8_t>{0, static_cast<std::uint8_t>(is_moved)};
                       }};
};

TEST_F(RunTrial, WhatWasMadeOfTheInputIsMadeOnce) {
  const Vec3 at = cube_.positions[0];
  const Vec3 by(-0.1, 0, 0);
  EXPECT_EQ(position_after_start("move", by), at + by);
  const std::size_t n_runs = n_runs_;
  // A plan that does nothing still finds out what must stay in place in the mesh at hand.
  driver_.run_plan({});
  EXPECT_EQ(position_after_start("move", by), at + by);
  EXPECT_EQ(n_runs_, n_runs);
  ASSERT_EQ(seen_.size(), 2U);
  EXPECT_EQ(seen_[0], seen_[1]);
  // A trial that fails leaves the mesh as it was before.
  EXPECT_EQ(driver_.mesh().tracked().soup.positions[0], at);
}

TEST_F(RunTrial, OtherPassesStartAgainFromTheInput) {
  const Vec3 at = cube_.positions[0];
  static_cast<void>(position_after_start("move", {-0.1, 0, 0}));
  EXPECT_EQ(position_after_start("move up", {0, 0, -0.2}), at + Vec3(0, 0, -0.2));
}

}  // namespace
}  // namespace meshalyzer
