#include "meshalyzer/repair/driver/internal/repair_driver.h"
#include "meshalyzer/repair/passes.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "unit/repair/split/split_passes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

/// Makes faces that all cross each other on one axis, and one that crosses none.
Soup star_of_faces(Index n_crossing) {
  Soup soup;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<Index>(soup.n_vertices());
    soup.positions.insert(soup.positions.end(), {a, b, c});
    soup.triangles.push_back({first, first + 1, first + 2});
  };
  for (Index i = 0; i < n_crossing; ++i) {
    const double angle = std::numbers::pi * i / n_crossing;
    const Vec3 out{std::cos(angle), std::sin(angle), 0.0};
    add(-out, out, Vec3{0.0, 0.0, 1.0 + 0.001 * i});
  }
  add({5, 0, 0}, {6, 0, 0}, {5, 1, 0});
  return soup;
}

/// Moves the last vertex a little: in a star, one of the face that crosses none.
PassResult move_last_vertex(const PassInput& input) {
  const Soup& soup = input.tracked.soup;
  PassResult result;
  const Index op = result.edits.begin_operation();
  const auto last = static_cast<Index>(soup.n_vertices() - 1);
  const Vec3 to = soup.positions[last] + Vec3{0.0, 0.01, 0.0};
  result.edits.moved_vertices.push_back({.op = op, .vertex = last, .to = to});
  return result;
}

/// Counts the runs of a pass that changes nothing, beside one that changes something in three
/// rounds.
std::size_t count_runs(Index n_crossing, bool takes_time_for_pairs) {
  const Soup soup = star_of_faces(n_crossing);
  RepairLimits limits;
  limits.max_deviation = 1.0;
  RepairDriver driver(soup, {}, limits, [](const TrackedMesh&, const CutMesh&) {
    return std::vector<std::uint8_t>();
  });
  std::size_t n_moves = 0;
  std::size_t n_runs = 0;
  const PassFunction move_once_a_round = [&](const PassInput& input) {
    const bool is_at_rest = n_moves++ % 2 != 0 || n_moves > 6;
    return is_at_rest ? PassResult() : move_last_vertex(input);
  };
  const PassFunction count = [&](const PassInput&) {
    ++n_runs;
    return PassResult();
  };
  driver.run_plan({{.name = "move", .run = move_once_a_round},
                   {.name = "count", .run = count, .takes_time_for_pairs = takes_time_for_pairs}});
  return n_runs;
}

TEST(RepairDriver, PassIsRunAgainAfterEachChangeOfTheMesh) {
  EXPECT_EQ(count_runs(150, false), 3U);
}

TEST(RepairDriver, PassThatTakesTimeForVeryManyPairsIsRunInVainOnce) {
  // All pairs of 150 faces are 11,175, and all of 100 are 4,950.
  EXPECT_EQ(count_runs(150, true), 1U);
  EXPECT_EQ(count_runs(100, true), 3U);
}

TEST(RepairDriver, WhatThePassRefusesIsLoggedThoughItsLastRunHasChangedTheMesh) {
  // All pairs of 270 faces are 36,315: in such a heap a pass does not run until it is done.
  const Soup soup = star_of_faces(270);
  RepairLimits limits;
  limits.max_deviation = 1.0;
  RepairDriver driver(soup, {}, limits, [](const TrackedMesh&, const CutMesh&) {
    return std::vector<std::uint8_t>();
  });
  const PassFunction move_and_refuse = [](const PassInput& input) {
    PassResult result = move_last_vertex(input);
    result.refused.push_back(
        {.code = DefectCode::SelfIntersection, .face = 0, .reason = "for a reason"});
    return result;
  };
  driver.run_plan({{.name = "move", .run = move_and_refuse}});
  ASSERT_EQ(driver.log().refusals.size(), 1U);
  EXPECT_EQ(driver.log().refusals.front().reason, "for a reason");
}

TEST(RepairDriver, EachPassThatTakesTimeForVeryManyPairsIsRunOnce) {
  const Soup soup = star_of_faces(150);
  RepairDriver driver(soup, {}, RepairLimits(), [](const TrackedMesh&, const CutMesh&) {
    return std::vector<std::uint8_t>();
  });
  std::vector<std::string> runs;
  const auto pass = [&](const char* name) {
    return PlannedPass{.name = name,
                       .run =
                           [&runs, name](const PassInput&) {
                             runs.emplace_back(name);
                             return PassResult();
                           },
                       .takes_time_for_pairs = true};
  };
  driver.run_plan({pass("first"), pass("second")});
  EXPECT_EQ(runs, (std::vector<std::string>{"first", "second"}));
}

TEST(RepairDriver, PassThatTakesTimeIsNotRunAgainForAnyNumberOfPairsThatItHasLeft) {
  // All pairs of 200 faces are 19,900, and all of 160 are 12,720.
  const Soup soup = shapes::merged(star_of_faces(200), shapes::cube(1, {8, 0, 0}));
  RepairDriver driver(
      soup, {}, RepairLimits{.max_deviation = 200.0, .fixed_vertices = {}},
      [](const TrackedMesh&, const CutMesh&) { return std::vector<std::uint8_t>(); });
  std::vector<std::size_t> pairs_of_runs;
  const PassFunction count = [&](const PassInput& input) {
    pairs_of_runs.push_back(input.mesh.intersecting_pairs().size());
    return PassResult();
  };
  const PassFunction move_faces_apart = [&](const PassInput& input) {
    PassResult result;
    if (input.mesh.intersecting_pairs().size() < 19'900) return result;
    const Index op = result.edits.begin_operation();
    for (Index v = 0; v < 40 * 3; ++v) {
      const double up = 3.0 * (1 + v / 3);
      const Vec3 to = soup.positions[v] + Vec3{0.0, 0.0, up};
      result.edits.moved_vertices.push_back({.op = op, .vertex = v, .to = to});
    }
    return result;
  };
  // This makes the mesh worse, so that all passes run again without it.
  std::size_t n_openings = 0;
  const PassFunction open_cube = [&](const PassInput& input) {
    PassResult result;
    if (input.tracked.soup.n_faces() < soup.n_faces()) return result;
    ++n_openings;
    const auto last = static_cast<Index>(soup.n_faces() - 1);
    result.edits.removed_faces.push_back({result.edits.begin_operation(), last});
    return result;
  };
  driver.run_plan({{.name = "count", .run = count, .takes_time_for_pairs = true},
                   {.name = "move", .run = move_faces_apart, .repeat = Repeat::OncePerRound},
                   {.name = "open", .run = open_cube, .may_create = {DefectCode::Hole}}});
  EXPECT_GT(n_openings, 1U);
  EXPECT_EQ(driver.mesh().tracked().soup.n_faces(), soup.n_faces());
  EXPECT_EQ(driver.mesh().prepared().intersecting_pairs().size(), 12'720U);
  EXPECT_EQ(pairs_of_runs, (std::vector<std::size_t>{19'900, 12'720}));
}

/// Counts the proposals of a pass that moves a face a number of times and leaves all pairs.
///
/// @param pass  The pass, without its function.
std::size_t count_moves(Index n_crossing, std::size_t n_moves, PlannedPass pass) {
  const Soup soup = star_of_faces(n_crossing);
  RepairDriver driver(
      soup, {}, RepairLimits{.max_deviation = 1.0, .fixed_vertices = {}},
      [](const TrackedMesh&, const CutMesh&) { return std::vector<std::uint8_t>(); });
  std::size_t n_proposals = 0;
  pass.run = [&](const PassInput& input) {
    return ++n_proposals > n_moves ? PassResult() : move_last_vertex(input);
  };
  driver.run_plan({pass});
  return n_proposals;
}

TEST(RepairDriver, PassThatLeavesNearlyAllOfVeryManyPairsIsNotRunAgain) {
  const PlannedPass pass{
      .name = "move", .run = {}, .repeat = Repeat::OncePerRound, .takes_time_for_pairs = true};
  EXPECT_EQ(count_moves(150, 3, pass), 1U);
  EXPECT_EQ(count_moves(100, 3, pass), 4U);
}

TEST(RepairDriver, InAHeapOfFacesPassesRunAFewTimesOnly) {
  const PlannedPass pass{.name = "move", .run = {}};
  // All pairs of 250 faces are 31,125, and all of 240 are 28,680.
  EXPECT_EQ(count_moves(250, 20, pass), 6U);
  EXPECT_EQ(count_moves(240, 20, pass), 22U);
}

TEST(RepairDriver, RoundsEndAfterThreeInSuccessionThatHaveLeftNoFewerDefects) {
  const PlannedPass pass{.name = "move", .run = {}, .repeat = Repeat::OncePerRound};
  // No round leaves fewer than the first.
  EXPECT_EQ(count_moves(30, 20, pass), 4U);
  EXPECT_EQ(count_moves(30, 2, pass), 3U);
}

TEST(RepairDriver, RoundsGoOnWhileOneInThreeLeavesFewerPairs) {
  const Soup soup = star_of_faces(30);
  RepairDriver driver(
      soup, {}, RepairLimits{.max_deviation = 2.0, .fixed_vertices = {}},
      [](const TrackedMesh&, const CutMesh&) { return std::vector<std::uint8_t>(); });
  std::size_t n_proposals = 0;
  const PassFunction drop_now_and_then = [&](const PassInput& input) {
    if (++n_proposals > 12) return PassResult();
    if (n_proposals % 3 != 0) return move_last_vertex(input);
    PassResult result;
    result.edits.removed_faces.push_back({result.edits.begin_operation(), 0});
    return result;
  };
  driver.run_plan({{.name = "drop", .run = drop_now_and_then, .repeat = Repeat::OncePerRound}});
  EXPECT_EQ(n_proposals, 13U);
  EXPECT_EQ(driver.mesh().tracked().soup.n_faces(), soup.n_faces() - 4);
}

/// Counts the proposals of a pass whose only operation moves the surface too far.
std::size_t count_proposals(bool has_smaller_operations) {
  const Soup soup = star_of_faces(1);
  RepairDriver driver(soup, {}, RepairLimits(), [](const TrackedMesh&, const CutMesh&) {
    return std::vector<std::uint8_t>();
  });
  std::size_t n_proposals = 0;
  const PassFunction move_too_far = [&](const PassInput& input) {
    ++n_proposals;
    PassResult result;
    result.has_smaller_operations = has_smaller_operations;
    const Index op = result.edits.begin_operation();
    const Vec3 to = input.tracked.soup.positions[0] + Vec3{0.0, 1.0, 0.0};
    result.edits.moved_vertices.push_back({.op = op, .vertex = 0, .to = to});
    return result;
  };
  driver.run_plan({{.name = "move", .run = move_too_far}});
  return n_proposals;
}

TEST(RepairDriver, PassIsRunForSmallerOperationsOnlyIfTheseDiffer) {
  EXPECT_EQ(count_proposals(true), 2U);
  EXPECT_EQ(count_proposals(false), 1U);
}

/// Counts the runs of a pass that takes time for pairs, after one that has split an edge, so that
/// each two of the faces at it touch.
std::size_t count_runs_after_split(Index n_faces, OnWorse on_worse) {
  const Soup soup = faces_round_edge(n_faces);
  RepairDriver driver(soup, {}, RepairLimits(), [](const TrackedMesh&, const CutMesh&) {
    return std::vector<std::uint8_t>();
  });
  std::size_t n_runs = 0;
  const PassFunction count = [&](const PassInput&) {
    ++n_runs;
    return PassResult();
  };
  using enum DefectCode;
  driver.run_plan({{.name = "split edges",
                    .run = split_edges_and_walls,
                    .may_create = {Hole, SelfIntersection}},
                   {.name = "count", .run = count, .takes_time_for_pairs = true}},
                  on_worse);
  return n_runs;
}

TEST(RepairDriver, PassThatTakesTimeIsNotRunForPairsThatAPlanHasMultiplied) {
  // All pairs of 160 faces are 12,720, and all of 100 are 4,950.
  EXPECT_EQ(count_runs_after_split(160, OnWorse::Leave), 0U);
  EXPECT_GT(count_runs_after_split(100, OnWorse::Leave), 0U);
  EXPECT_GT(count_runs_after_split(160, OnWorse::TryAgain), 0U);
}

}  // namespace
}  // namespace meshalyzer
