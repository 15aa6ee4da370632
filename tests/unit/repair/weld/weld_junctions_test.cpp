#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/weld/weld_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

TEST(WeldBorders, StoppedOneLooksForNoNearBorders) {
  const Soup torn = jittered(unwelded(shapes::icosphere(1)), 0.004, 3);
  const TrackedMesh tracked = track_mesh(torn);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances = resolve_tolerances({}, box_of(torn));
  const RepairLimits limits = wide_limits(torn);
  PassInput input{torn, tracked, mesh, tolerances, limits};
  EXPECT_FALSE(weld(0.014)(input).edits.empty());
  input.wants_to_stop = [] { return true; };
  EXPECT_TRUE(weld(0.014)(input).edits.empty());
}

TEST(WeldBorders, CrackWithJunctionsIsClosed) {
  for (const double gap : {0.0, 0.001}) {
    const Soup torn = crack_with_junctions(gap, {0.25, 0.5, 0.75});
    const PassRun run = run_pass(torn, weld(0.002));
    EXPECT_EQ(run.operations, 1U);
    // Four faces below, and four that the upper one is split into: the hub on either side, and five
    // vertices on the seam.
    const SeamTopology expected{
        .vertices = 7, .edges = 14, .faces = 8, .border_edges = 4, .components = 1};
    EXPECT_EQ(seam_topology_of(run.tracked.soup), expected);
    for (Index i = 0; i < 3; ++i) {
      EXPECT_NE(std::find(run.tracked.soup.positions.begin(), run.tracked.soup.positions.end(),
                          torn.positions[5 + i]),
                run.tracked.soup.positions.end());
    }
  }
}

TEST(WeldBorders, JunctionFartherThanTheToleranceIsLeft) {
  Soup torn = crack_with_junctions(0.0, {0.5});
  torn.positions[5].y() = -0.0625;
  EXPECT_TRUE(same_soup(welded(torn, 0.06), torn));
  EXPECT_EQ(seam_topology_of(welded(torn, 0.0625)).border_edges, 4U);
}

TEST(WeldBorders, JunctionsCloserToEachOtherThanTheToleranceAreClosed) {
  // The gap is far smaller than the steps along the crack, which are shorter than the tolerance.
  const Soup torn = crack_with_junctions(1e-9, {0.02, 0.04, 0.5, 0.97});
  for (const double within : {1e-8, 1e-3, 0.03, 0.1}) {
    EXPECT_EQ(seam_topology_of(welded(torn, within)).border_edges, 4U) << within;
  }
}

TEST(WeldBorders, JunctionAtTheTipOfAFanIsClosed) {
  // The long edge ends where many others do, so that the chain is followed from its start.
  for (const bool is_turned : {false, true}) {
    Soup torn = crack_with_junctions(0.001, {0.25, 0.5});
    const Vec3 tip = torn.positions[1];
    for (int i = 0; i < 40; ++i) {
      torn = shapes::merged(
          torn, shapes::make({tip, {2, 1 + 0.1 * i, 5}, {2, 1.05 + 0.1 * i, 5}}, {{0, 1, 2}}));
    }
    if (is_turned) torn = shapes::flipped(torn);
    const std::size_t before = seam_topology_of(torn).border_edges;
    // One long edge and three short ones.
    EXPECT_EQ(seam_topology_of(welded(torn, 0.002)).border_edges, before - 4);
  }
}

TEST(WeldBorders, JunctionBetweenFacesOfABodyIsLeft) {
  Soup torn = crack_with_junctions(0.0, {0.5});
  torn.groups = {{"above", 0}, {"below", 1}};
  RepairLimits limits = any_distance();
  limits.groups = Groups::Faces;
  EXPECT_TRUE(same_soup(run_pass(torn, weld(0.01), limits).tracked.soup, torn));
  limits.groups = Groups::Names;
  const Soup mended = run_pass(torn, weld(0.01), limits).tracked.soup;
  EXPECT_EQ(seam_topology_of(mended).border_edges, 4U);
  // The added face has joined its group.
  EXPECT_EQ(mended.groups[1].first_face, 2U);
}

TEST(WeldBorders, SolidWithJunctionsOnAllSidesIsClosed) {
  // The sides of a cube by themselves, the upper and lower one finer than the other four.
  const auto side = [](std::size_t n, const std::function<Vec3(double, double)>& place) {
    Soup soup = shapes::grid(n, n);
    for (Vec3& p : soup.positions) {
      p = place(p.x() / static_cast<double>(n), p.y() / static_cast<double>(n));
    }
    return soup;
  };
  Soup cube = side(4, [](double u, double v) { return Vec3(u, v, 1); });
  cube = shapes::merged(cube, side(4, [](double u, double v) { return Vec3(v, u, 0); }));
  cube = shapes::merged(cube, side(1, [](double u, double v) { return Vec3(u, 0, v); }));
  cube = shapes::merged(cube, side(1, [](double u, double v) { return Vec3(v, 1, u); }));
  cube = shapes::merged(cube, side(1, [](double u, double v) { return Vec3(0, v, u); }));
  cube = shapes::merged(cube, side(1, [](double u, double v) { return Vec3(1, u, v); }));
  const Soup mended = welded(cube, 1e-6);
  const SeamTopology after = seam_topology_of(mended);
  EXPECT_EQ(after.border_edges, 0U);
  EXPECT_EQ(after.non_manifold_edges + after.flipped_edges + after.non_manifold_vertices, 0U);
  EXPECT_EQ(after.vertices + after.faces, after.edges + 2);
  // All there was: 25 vertices a fine side.
  EXPECT_EQ(after.vertices, 50U);
}

TEST(WeldBorders, SlitAtAJunctionIsNoChainOfOneFace) {
  // A triangle whose corner lies on the opposite side: its own edges run along it.
  const Soup cap = shapes::make({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}, {{0, 1, 2}});
  const PassRun run = run_pass(cap, weld(1e-3), any_distance());
  EXPECT_TRUE(same_soup(run.tracked.soup, cap));
  EXPECT_TRUE(run.refused.empty());
}

TEST(WeldBorders, SplitThatWouldTurnAFaceOverIsNotMade) {
  // The vertex of the lower side is above the flat face that it would split.
  Soup torn = crack_with_junctions(0.0, {0.5});
  torn.positions[5].y() = 0.002;
  const auto tip = static_cast<Index>(torn.positions.size());
  torn.positions.emplace_back(0.5, 0.001, 0);
  torn.triangles[0] = {0, 1, tip};
  torn.triangles.push_back({tip, 1, 2});
  torn.triangles.push_back({0, tip, 2});
  const PassRun run = run_pass(torn, weld(0.01), any_distance());
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].reason, "joining them would turn a face over");
}

TEST(WeldBorders, CrackWithVerticesThatDoNotFaceEachOtherIsClosed) {
  for (const double gap : {0.0, 0.001}) {
    const Soup torn = interleaved_crack(gap, {0.3, 0.7}, {0.5});
    const PassRun run = run_pass(torn, weld(0.002));
    EXPECT_EQ(run.operations, 1U);
    // The mesh is that of CrackWithJunctionsIsClosed.
    const SeamTopology expected{
        .vertices = 7, .edges = 14, .faces = 8, .border_edges = 4, .components = 1};
    EXPECT_EQ(seam_topology_of(run.tracked.soup), expected);
  }
}

TEST(WeldBorders, InterleavedCracksOfAnySortAreClosed) {
  std::mt19937 random(7);
  const auto places = [&] {
    // On a lattice, so that a vertex may face another, and none is too near the next.
    std::vector<double> chosen;
    for (int i = 1; i < 40; ++i) {
      if (random() % 4 == 0) chosen.push_back(i / 40.0);
    }
    return chosen;
  };
  for (int trial = 0; trial < 50; ++trial) {
    SCOPED_TRACE(trial);
    const Soup torn = interleaved_crack(trial % 2 == 0 ? 0.0 : 1e-4, places(), places());
    const SeamTopology found = seam_topology_of(welded(torn, 0.001));
    EXPECT_EQ(found.border_edges, 4U);
    EXPECT_EQ(found.non_manifold_vertices, 0U);
    EXPECT_EQ(found.flipped_edges, 0U);
  }
}

TEST(WeldBorders, InterleavedCrackThatIsTooWideIsLeft) {
  const Soup torn = interleaved_crack(0.01, {0.3, 0.7}, {0.5});
  EXPECT_TRUE(same_soup(welded(torn, 0.009), torn));
}

TEST(WeldBorders, SmallerOperationsJoinWithinHalfOfTheLength) {
  const auto operations_within = [](double within, OperationSize size) {
    const Soup torn = interleaved_crack(0.001, {0.3, 0.7}, {0.5});
    const PassFunction pass = [&](PassInput input) {
      input.operation_size = size;
      return weld(within)(input);
    };
    return run_pass(torn, pass).operations;
  };
  EXPECT_EQ(operations_within(0.0015, OperationSize::Normal), 1U);
  EXPECT_EQ(operations_within(0.0015, OperationSize::Smallest), 0U);
  EXPECT_EQ(operations_within(0.0025, OperationSize::Smallest), 1U);
}

TEST(WeldBorders, SplitAlongAnEdgeThatIsThereIsNotMade) {
  // A tetrahedron has the edge already that the upper face would be split along.
  Soup torn = crack_with_junctions(0.0, {0.5});
  const auto p = static_cast<Index>(torn.positions.size());
  torn.positions.emplace_back(0.5, 0.5, 1);
  torn.positions.emplace_back(0.7, 0.5, 1);
  for (const Triangle& t : {Triangle{5, 2, p}, {2, 5, p + 1}, {5, p, p + 1}, {2, p + 1, p}}) {
    torn.triangles.push_back(t);
  }
  const PassRun run = run_pass(torn, weld(0.01), any_distance());
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].reason, "joining them would make an edge with more than two faces");
}

}  // namespace
}  // namespace meshalyzer
