#include "meshalyzer/repair/facets/internal/collapse_edge.h"
#include "meshalyzer/repair/facets/internal/link_condition.h"
#include "meshalyzer/repair/facets/internal/retract_cap.h"
#include "meshalyzer/repair/facets/internal/step_journal.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"
#include "support/run_pass.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

/// A mesh to try single steps on; faces are thin where the test says so.
struct MendFixture {
  TrackedMesh tracked;
  PreparedMesh built{tracked.soup};
  Tolerances tolerances;
  RepairLimits limits;
  WorkingMesh mesh;
  PassInput input{tracked.soup, tracked, built, tolerances, limits};
  MendRules rules{input};

  explicit MendFixture(const Soup& soup, double tolerance = 1e-8, std::vector<Index> thin = {})
      : tracked(track_mesh(soup)),
        tolerances{.degeneracy = tolerance},
        limits{.max_deviation = std::numeric_limits<double>::max(), .fixed_vertices = {}},
        mesh(tracked.soup, thin, tolerance) {}

  [[nodiscard]] bool may_merge_ends(Index gone, Index kept) const {
    MendStep step;
    return may_merge(mesh, {gone, kept}, fin_tips_at(mesh, gone, kept, step), step);
  }
};

TEST(LookRound, VertexOfAClosedSurfaceIsPlain) {
  EXPECT_EQ(look_round(MendFixture(shapes::cube()).mesh, 0).kind, VertexKind::Plain);
}

TEST(LookRound, VertexOfABorderIsOnARidgeBetweenItsNeighboursThere) {
  const VertexSurroundings round = look_round(MendFixture(shapes::grid(2, 1)).mesh, 1);
  EXPECT_EQ(round.kind, VertexKind::Ridge);
  EXPECT_EQ(round.along, (std::array<Index, 2>{0, 2}));
}

TEST(LookRound, PinchedVertexAndEndOfANonManifoldEdgeAreCorners) {
  // Vertex 0 is the one in common.
  EXPECT_EQ(look_round(MendFixture(shapes::two_tetrahedra_sharing_vertex()).mesh, 0).kind,
            VertexKind::Corner);
  EXPECT_EQ(look_round(MendFixture(shapes::two_tetrahedra_sharing_edge()).mesh, 0).kind,
            VertexKind::Corner);
}

TEST(LookRound, MiddleOfANonManifoldEdgeIsOnARidge) {
  // Three half discs on the line 0 1 2.
  Soup soup = shapes::make({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
                           {{0, 1, 3}, {1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {0, 1, 5}, {1, 2, 5}});
  EXPECT_EQ(look_round(MendFixture(soup).mesh, 1).kind, VertexKind::Ridge);
  // With one more, closed fan it is none.
  soup.positions.insert(soup.positions.end(), {{0, 0, 5}, {1, 0, 5}, {0, 1, 5}});
  soup.triangles.insert(soup.triangles.end(), {{1, 6, 7}, {1, 7, 8}, {1, 8, 6}});
  EXPECT_EQ(look_round(MendFixture(soup).mesh, 1).kind, VertexKind::Corner);
}

TEST(MayMerge, EdgeOfASphereMayGoButNoneOfATetrahedron) {
  const MendFixture sphere(shapes::icosphere(1));
  const Triangle& t = sphere.mesh.triangle(0);
  EXPECT_TRUE(sphere.may_merge_ends(t[0], t[1]));
  EXPECT_FALSE(MendFixture(shapes::tetrahedron()).may_merge_ends(0, 1));
}

TEST(MayMerge, NoEdgeOfALoneTriangleOrAPillowMayGo) {
  EXPECT_FALSE(MendFixture(shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}))
                   .may_merge_ends(0, 1));
  EXPECT_FALSE(MendFixture(shapes::pillow()).may_merge_ends(0, 1));
}

TEST(MayMerge, EdgeAcrossASheetBetweenTwoPlacesOfItsBorderMayNotGo) {
  const Soup soup = shapes::grid(1, 1);
  const MendFixture sheet(soup);
  // One diagonal of the square is its inner edge.
  const bool is_first = sheet.mesh.are_joined(0, 3);
  EXPECT_FALSE(sheet.may_merge_ends(is_first ? 0 : 1, is_first ? 3 : 2));
  EXPECT_TRUE(sheet.may_merge_ends(1, 0));
}

TEST(MayMerge, FinOfOneFaceOnASurfaceMayNotShrinkIntoIt) {
  Soup soup = shapes::icosphere(1);
  const Triangle t = soup.triangles[0];
  const auto tip = static_cast<Index>(soup.n_vertices());
  soup.positions.emplace_back(2, 2, 2);
  soup.triangles.push_back({t[0], t[1], tip});
  const MendFixture fin(soup);
  EXPECT_FALSE(fin.may_merge_ends(tip, t[0]));
  // Its ends on the surface are corners.
  EXPECT_FALSE(fin.may_merge_ends(t[0], tip));
}

/// A tetrahedron with a vertex, 4, above the middle of the edge 0 1, in the face 0 1 2. On the face
/// 0 4 2 there is a fin, of which the tip is vertex 5.
Soup tetrahedron_with_fin() {
  return shapes::make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0, 0}, {0.1, 0.5, -0.2}},
      {{0, 5, 4}, {4, 5, 2}, {2, 5, 0}, {4, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

TEST(FinTipsAt, VertexWithThreeFacesIsATipBetweenItsNeighbours) {
  const MendFixture fixture(tetrahedron_with_fin());
  MendStep step;
  const std::vector<FinTip> fins = fin_tips_at(fixture.mesh, 0, 4, step);
  ASSERT_EQ(fins.size(), 1U);
  EXPECT_EQ(fins[0].tip, 5U);
  EXPECT_EQ(fins[0].third_neighbour, 2U);
  EXPECT_TRUE(fin_tips_at(fixture.mesh, 4, 1, step).empty());
  EXPECT_EQ(step.read_vertices, std::vector<Index>{5});
}

TEST(MayMerge, EdgeWithAFinMayGoUnlessAThirdVertexJoinsItsEnds) {
  // Without the fin's tip, 0 and 4 have the vertices 2 and 3 of their faces in common.
  EXPECT_TRUE(MendFixture(tetrahedron_with_fin()).may_merge_ends(4, 0));
  // Two fins on the faces of an edge of a tetrahedron: all its vertices are joined.
  const MendFixture tetrahedron(
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.3, 0.3, -1}},
                   {{0, 4, 1}, {1, 4, 2}, {2, 4, 0}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}));
  EXPECT_FALSE(tetrahedron.may_merge_ends(0, 1));
}

TEST(CollapseEdge, FinAtTheEdgeGoesWithItAsFarAsItIsHigh) {
  MendFixture fixture(tetrahedron_with_fin());
  const MendAttempt attempt = collapse_edge(fixture.mesh, fixture.rules, {0, 4});
  ASSERT_TRUE(attempt.is_possible());
  // The tip is 0.2 below the plane of the face 0 2 1, which all of the fin stands on.
  EXPECT_NEAR(attempt.deviation, 0.2, 1e-12);
  fixture.mesh.make(attempt.step);
  EXPECT_TRUE(fixture.mesh.faces_at(4).empty());
  EXPECT_TRUE(fixture.mesh.faces_at(5).empty());
  for (const Index v : {0U, 1U, 2U, 3U}) EXPECT_EQ(fixture.mesh.faces_at(v).size(), 3U);
}

TEST(CollapseEdge, FinThatIsTooHighOrFixedStays) {
  MendFixture fixture(tetrahedron_with_fin());
  fixture.limits.max_deviation = 0.19;
  EXPECT_EQ(collapse_edge(fixture.mesh, fixture.rules, {0, 4}).outcome, MendOutcome::TooFar);
  fixture.limits.max_deviation = 0.21;
  EXPECT_TRUE(collapse_edge(fixture.mesh, fixture.rules, {0, 4}).is_possible());
  fixture.limits.fixed_vertices = {0, 0, 0, 0, 0, 1};
  EXPECT_EQ(collapse_edge(fixture.mesh, fixture.rules, {0, 4}).outcome, MendOutcome::Fixed);
}

/// A flat fan of faces round vertex 0, over an arrow-shaped polygon: seen from vertex 1, not all of
/// it can be seen.
Soup arrow() {
  return shapes::make({{0, 0, 0}, {3, 0, 0}, {-1, 2, 0}, {-0.5, 0, 0}, {-1, -2, 0}},
                      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
}

TEST(CollapseEdge, EndFromWhichANeighbourWouldBeTurnedOverIsNotTaken) {
  // Of the border, so that only vertex 0 can go. Merged into 2, the face 0 3 4 would be turned.
  MendFixture fixture(arrow());
  fixture.limits.fixed_vertices = {0, 1, 1, 1, 1};
  const MendAttempt attempt = collapse_edge(fixture.mesh, fixture.rules, {0, 2});
  EXPECT_EQ(attempt.outcome, MendOutcome::TurnsOver);
  EXPECT_TRUE(collapse_edge(fixture.mesh, fixture.rules, {0, 3}).is_possible());
}

TEST(CollapseEdge, VertexMovesInItsPlaneWithoutDeviation) {
  MendFixture fixture(arrow());
  fixture.limits.fixed_vertices = {0, 1, 1, 1, 1};
  const MendAttempt attempt = collapse_edge(fixture.mesh, fixture.rules, {0, 3});
  EXPECT_LE(attempt.deviation, 1e-15);
}

TEST(CollapseEdge, OfTwoEndsTheOneGoesWhoseFacesAreFlat) {
  // Vertex 0 is in the middle of the top of a pyramid's side; vertex 1 is the pyramid's top.
  const Soup soup = shapes::make({{0.5, 0, 0.5}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}, {-1, 0, 0}},
                                 {{0, 1, 3}, {0, 3, 2}, {0, 2, 1}, {1, 2, 4}, {1, 4, 3}});
  const MendFixture fixture(soup);
  const MendAttempt attempt = collapse_edge(fixture.mesh, fixture.rules, {0, 1});
  ASSERT_TRUE(attempt.is_possible());
  for (const auto& change : attempt.step.changed) {
    if (change.corners == kNoTriangle) continue;
    EXPECT_EQ(std::count(change.corners.begin(), change.corners.end(), 0U), 0);
  }
}

TEST(RetractCap, ApexThatIsJoinedToTheVertexBeyondAlreadyIsLeft) {
  // The cap 0 1 2 has its apex 2 on the edge 0 1, and beyond that is 3, which 2 is joined to on the
  // other side. Vertex 0 has a fourth face, because of vertex 5.
  const Soup soup =
      shapes::make({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {1, 0, 3}, {0.5, 0.3, 0.1}},
                   {{0, 1, 2}, {1, 0, 3}, {0, 2, 5}, {2, 3, 5}, {3, 0, 5}, {1, 3, 4}, {3, 2, 4}});
  const MendFixture fixture(soup, 1e-8, {0});
  EXPECT_EQ(retract_cap(fixture.mesh, fixture.rules, 0, RetractGain::FewerThin).outcome,
            MendOutcome::Topology);
}

/// Vertex 0 has three faces; the cap 0 1 2 has its apex 2 on the edge 0 1, and beyond that is 3,
/// which the third face joins 2 to.
Soup cap_beside_end_with_three_faces() {
  return shapes::make({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {1, 0, 3}},
                      {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {1, 3, 4}, {3, 2, 4}});
}

TEST(RetractCap, EndWithThreeFacesGoesWithTheCap) {
  MendFixture fixture(cap_beside_end_with_three_faces(), 1e-8, {0});
  const auto retract = [&] {
    return retract_cap(fixture.mesh, fixture.rules, 0, RetractGain::FewerThin);
  };
  const MendAttempt attempt = retract();
  ASSERT_TRUE(attempt.is_possible());
  // In the plane of the half 1 2 3 that stays, vertex 0 sees the edge from 2 to 3 in the direction
  // of (-1, 2), 1 away from 2: the distance is 2 / sqrt 5.
  EXPECT_NEAR(attempt.deviation, 2.0 / std::sqrt(5.0), 1e-12);
  fixture.limits.max_deviation = 0.89;
  EXPECT_EQ(retract().outcome, MendOutcome::TooFar);
  fixture.limits.max_deviation = 0.9;
  fixture.limits.fixed_vertices = {1, 0, 0, 0, 0};
  EXPECT_EQ(retract().outcome, MendOutcome::Fixed);
  fixture.mesh.make(attempt.step);
  EXPECT_TRUE(fixture.mesh.faces_at(0).empty());
  EXPECT_EQ(fixture.mesh.triangle(1), (Triangle{1, 2, 3}));
  EXPECT_EQ(fixture.mesh.faces_at(2).size(), 2U);
}

TEST(RetractCap, FlatTetrahedronGoesAsAWhole) {
  const Soup soup = shapes::make({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0.5, 1, 0}},
                                 {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}});
  MendFixture fixture(soup, 1e-8, {0});
  const MendAttempt attempt = retract_cap(fixture.mesh, fixture.rules, 0, RetractGain::FewerThin);
  ASSERT_TRUE(attempt.is_possible());
  EXPECT_EQ(attempt.step.changed.size(), 4U);
  fixture.mesh.make(attempt.step);
  for (Index v = 0; v < 4; ++v) EXPECT_TRUE(fixture.mesh.faces_at(v).empty());
}

TEST(RetractCap, CapWhoseApexIsOnTheBorderTooIsLeftAtTheBorder) {
  // The edges 0 1 and 2 0 of the cap are both of the border.
  const Soup soup =
      shapes::make({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}});
  const MendFixture fixture(soup, 1e-8, {0});
  EXPECT_EQ(retract_cap(fixture.mesh, fixture.rules, 0, RetractGain::FewerThin).outcome,
            MendOutcome::Topology);
}

TEST(RetractCap, ApexBeyondTheFaceThatWouldBeSplitIsLeft) {
  // The cap is folded onto the face 1 0 3, and its apex sticks out of it: one half would be turned
  // over. The face is 0.12 high, above the tolerance; the cap 0.09.
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {0.5, -0.09, 0}, {0.1, -0.12, 0}},
                                 {{0, 1, 2}, {1, 0, 3}});
  const MendFixture fixture(soup, 0.1, {0});
  EXPECT_EQ(retract_cap(fixture.mesh, fixture.rules, 0, RetractGain::FewerThin).outcome,
            MendOutcome::TurnsOver);
  // The same is true where the face is thin itself, and its halves are.
  const MendFixture thin(soup, 0.13, {0, 1});
  EXPECT_EQ(retract_cap(thin.mesh, thin.rules, 0, RetractGain::FewerThin).outcome,
            MendOutcome::TurnsOver);
}

TEST(WorkingMesh, FacesAtAMovedVertexAreJudgedAnew) {
  MendFixture fixture(shapes::grid(1, 1));
  ASSERT_FALSE(fixture.mesh.is_thin(0));
  MendStep step;
  // All of the square's vertices are in line with the diagonal then, or on it.
  step.moved = {1, fixture.mesh.position(0)};
  fixture.mesh.make(step);
  const Triangle& t = fixture.mesh.triangle(0);
  const bool has_both =
      std::count(t.begin(), t.end(), 0U) + std::count(t.begin(), t.end(), 1U) == 2;
  EXPECT_EQ(fixture.mesh.is_thin(0), has_both);
}

TEST(StepJournal, StepThatReliesOnAnEdgeAnotherHasTakenIsOfTheSameOperation) {
  const MendFixture fixture(shapes::icosphere(2));
  const Triangle& t = fixture.mesh.triangle(0);
  const std::vector<Index> both = fixture.mesh.faces_at(t[0], t[1]);
  ASSERT_EQ(both.size(), 2U);
  for (const bool are_apart : {false, true}) {
    WorkingMesh mesh = fixture.mesh;
    StepJournal journal(OperationSize::Normal);
    std::vector<Index> gone{both[0], both[1]};
    // On a sphere of 320 faces the last one has nothing to do with the first.
    if (are_apart) gone[1] = 319;
    for (const Index f : gone) {
      MendStep step;
      step.changed.push_back({f, kNoTriangle});
      ASSERT_TRUE(journal.record(mesh, step));
      mesh.make(step);
    }
    EXPECT_EQ(journal.edits(fixture.tracked.soup, mesh).n_operations, are_apart ? 2U : 1U);
  }
}

}  // namespace
}  // namespace meshalyzer
