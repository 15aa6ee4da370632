#include "support/effort.h"
#include "support/random_soups.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/weld/weld_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

TEST(WeldBorders, UnweldedClosedMeshesComeBackWhole) {
  std::uint32_t seed = 1;
  for (const Soup& shape : closed_shapes()) {
    const Soup torn =
        shapes::renumbered_vertices(shapes::shuffled_faces(unwelded(shape), seed), seed + 1);
    const Soup mended = welded(torn, 0.0);
    EXPECT_EQ(seam_topology_of(mended), seam_topology_of(shape));
    EXPECT_TRUE(same_bits(corner_positions(mended), corner_positions(torn)));
    EXPECT_EQ(mended.n_vertices(), shape.n_vertices());
    seed += 2;
  }
}

TEST(WeldBorders, OneRoundIsEnoughForCoincidentBorders) {
  const PassRun run = run_pass(unwelded(shapes::icosphere(2)), weld(0.0));
  EXPECT_EQ(run.rounds, 1U);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_TRUE(run.refused.empty());
}

TEST(WeldBorders, JitteredClosedMeshesComeBackWhole) {
  std::uint32_t seed = 11;
  for (const Soup& shape : closed_shapes()) {
    // The shortest edge of them is longer than 0.2. Copies of a vertex are at most 2 sqrt(3) times
    // the jitter apart.
    const double jitter = 0.004;
    const Soup torn = jittered(shapes::shuffled_faces(unwelded(shape), seed), jitter, seed);
    const Soup mended = welded(torn, 3.47 * jitter);
    EXPECT_EQ(seam_topology_of(mended), seam_topology_of(shape));
    const std::vector<Vec3> before = corner_positions(torn);
    const std::vector<Vec3> after = corner_positions(mended);
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_LE((before[i] - after[i]).norm(), 3.47 * jitter);
    }
    ++seed;
  }
}

TEST(WeldBorders, MeshWithoutCoincidentBordersIsLeft) {
  for (const Soup& soup : {shapes::icosphere(1), shapes::open_cube(), shapes::grid(4, 3),
                           shapes::moebius_strip(7), shapes::fan_of_three(), Soup{}}) {
    const PassRun run = run_pass(soup, weld(1e-3));
    EXPECT_EQ(run.operations, 0U);
    EXPECT_TRUE(run.refused.empty());
    EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  }
}

TEST(WeldBorders, UnweldedMoebiusStripKeepsItsBorder) {
  const Soup strip = shapes::moebius_strip(9);
  const Soup mended = welded(unwelded(strip), 0.0);
  // Where the strip closes its faces meet with opposite orientation, as before.
  EXPECT_EQ(seam_topology_of(mended), seam_topology_of(strip));
}

TEST(WeldBorders, FacesTurnedAtRandomAreJoinedAllTheSame) {
  const Soup shape = shapes::icosphere(1);
  std::mt19937 random(5);
  std::vector<Index> turned;
  for (Index f = 0; f < shape.n_faces(); ++f) {
    if (below(random, 3) == 0) turned.push_back(f);
  }
  const Soup torn = shapes::flipped(shape, turned);
  EXPECT_EQ(seam_topology_of(welded(unwelded(torn), 0.0)), seam_topology_of(torn));
}

TEST(WeldBorders, SlitInSphereIsClosedAndNothingElseTouched) {
  const Soup sphere = shapes::icosphere(2);
  // Along a chain of four edges that goes on from one end as straight as it can.
  std::vector<Index> chain{sphere.triangles[0][0], sphere.triangles[0][1]};
  for (int i = 0; i < 3; ++i) {
    const Vec3 ahead =
        2 * sphere.positions[chain.back()] - sphere.positions[chain[chain.size() - 2]];
    Index best = kNoIndex;
    for (const Triangle& t : sphere.triangles) {
      if (std::find(t.begin(), t.end(), chain.back()) == t.end()) continue;
      for (const Index v : t) {
        if (v == chain.back() || v == chain[chain.size() - 2]) continue;
        if (best == kNoIndex ||
            (sphere.positions[v] - ahead).norm() < (sphere.positions[best] - ahead).norm()) {
          best = v;
        }
      }
    }
    chain.push_back(best);
  }
  const Soup torn = slit_open(sphere, chain);
  ASSERT_EQ(seam_topology_of(torn).border_edges, 8U);
  const PassRun run = run_pass(torn, weld(0.0));
  EXPECT_EQ(run.operations, 1U);
  EXPECT_TRUE(same_soup(run.tracked.soup, sphere));
}

TEST(WeldBorders, SlitsApartAreOperationsApart) {
  const Soup torn = shapes::merged(two_triangles_apart(0.0),
                                   shapes::translated(two_triangles_apart(0.0), {5, 0, 0}));
  EXPECT_EQ(run_pass(torn, weld(0.0)).operations, 2U);
}

TEST(WeldBorders, GapBelowToleranceIsClosedAndAboveIsNot) {
  // 2^-10, so that every figure is exact.
  const double gap = 0.0009765625;
  const Soup torn = two_triangles_apart(gap);
  EXPECT_EQ(welded(torn, gap).n_vertices(), 4U);
  EXPECT_TRUE(same_soup(welded(torn, std::nextafter(gap, 0.0)), torn));
}

TEST(WeldBorders, GapAboveDeviationIsNotClosed) {
  const Soup torn = two_triangles_apart(0.01);
  RepairLimits limits = any_distance();
  limits.max_deviation = 0.009;
  EXPECT_EQ(run_pass(torn, weld(0.1), limits).operations, 0U);
  limits.max_deviation = 0.011;
  EXPECT_EQ(run_pass(torn, weld(0.1), limits).operations, 1U);
}

TEST(WeldBorders, VertexWithMoreFacesStays) {
  Soup torn = two_triangles_apart(0.01);
  // A further face at vertex 3, which now has two.
  torn.positions.emplace_back(-0.5, -1, 0);
  torn.triangles.push_back({3, 6, 5});
  const Soup mended = welded(torn, 0.02);
  ASSERT_EQ(mended.n_vertices(), 5U);
  // 0 goes to 3 and 4 goes to 1.
  EXPECT_EQ(mended.positions[mended.triangles[0][0]], Vec3(0, -0.01, 0));
  EXPECT_EQ(mended.positions[mended.triangles[0][1]], Vec3(1, 0, 0));
}

TEST(WeldBorders, FixedVertexStays) {
  const Soup torn = two_triangles_apart(0.01);
  RepairLimits limits = any_distance();
  limits.fixed_vertices = {0, 0, 0, 0, 1};
  const Soup mended = run_pass(torn, weld(0.02), limits).tracked.soup;
  EXPECT_EQ(mended.positions[mended.triangles[0][0]], Vec3(0, 0, 0));
  EXPECT_EQ(mended.positions[mended.triangles[0][1]], Vec3(1, -0.01, 0));
}

TEST(WeldBorders, FixedVerticesAreJoinedOnlyAtOnePlace) {
  RepairLimits limits = any_distance();
  limits.fixed_vertices = {1, 1, 1, 1, 1, 1};
  EXPECT_EQ(run_pass(two_triangles_apart(0.01), weld(0.02), limits).operations, 0U);
  EXPECT_EQ(run_pass(two_triangles_apart(0.0), weld(0.02), limits).operations, 1U);
}

TEST(WeldBorders, ZeroAndMinusZeroAreOnePlace) {
  Soup torn = two_triangles_apart(0.0);
  for (Vec3& p : torn.positions) p.z() = &p - torn.positions.data() < 3 ? 0.0 : -0.0;
  EXPECT_EQ(welded(torn, 0.0).n_vertices(), 4U);
}

/// Two tetrahedra on the edge from (0,0,0) to (0,0,1), each in a quadrant of its own.
Soup two_tetrahedra_at_edge() {
  const Soup one = shapes::make({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  Soup other = one;
  for (Vec3& p : other.positions) p = Vec3(-p.x(), -p.y(), p.z());
  return shapes::merged(one, other);
}

TEST(WeldBorders, SolidsThatTouchAlongAnEdgeStayApart) {
  const Soup solids = two_tetrahedra_at_edge();
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Soup torn = shapes::shuffled_faces(unwelded(solids), seed);
    EXPECT_EQ(seam_topology_of(welded(torn, 0.0)), seam_topology_of(solids)) << seed;
    EXPECT_EQ(seam_topology_of(welded(jittered(torn, 0.001, seed), 0.005)),
              seam_topology_of(solids))
        << seed;
  }
}

TEST(WeldBorders, CubesThatTouchAlongASideStayApart) {
  // Squares are split alike, so that four faces are on the diagonal of the common side.
  for (const Vec3& by : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)}) {
    const Soup cubes = shapes::merged(shapes::cube(), shapes::translated(shapes::cube(), by));
    EXPECT_EQ(seam_topology_of(welded(unwelded(cubes), 0.0)), seam_topology_of(cubes));
  }
}

TEST(WeldBorders, SolidThatAPillowTouchesIsClosed) {
  // A cube, and two faces back to back that stand on one of its edges.
  Soup soup = shapes::cube();
  const auto first = static_cast<Index>(soup.positions.size());
  soup.positions.push_back(soup.positions[soup.triangles[0][0]]);
  soup.positions.push_back(soup.positions[soup.triangles[0][1]]);
  soup.positions.emplace_back(-1, -2, -3);
  soup.triangles.push_back({first, first + 1, first + 2});
  soup.triangles.push_back({first + 1, first, first + 2});
  const Soup mended = welded(unwelded(soup), 0.0);
  const SeamTopology cube = seam_topology_of(shapes::cube());
  const SeamTopology after = seam_topology_of(mended);
  // Nothing of the pillow is joined: that would make a face and its opposite.
  EXPECT_EQ(after.border_edges, 6U);
  EXPECT_EQ(after.edges, cube.edges + 6);
  EXPECT_EQ(after.components, 3U);
}

TEST(WeldBorders, SolidsThatTouchInAPointStayApart) {
  const Soup cubes = shapes::merged(shapes::cube(), shapes::cube(1.0, {1, 1, 1}));
  EXPECT_EQ(seam_topology_of(welded(unwelded(cubes), 0.0)), seam_topology_of(cubes));
}

TEST(WeldBorders, ThreeSheetsAtAnEdgeAreRefused) {
  const Soup torn = unwelded(shapes::fan_of_three());
  const PassRun run = run_pass(torn, weld(1e-6));
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].code, DefectCode::Slit);
  EXPECT_EQ(run.refused[0].face, 0U);
  EXPECT_TRUE(same_soup(run.tracked.soup, torn));
}

TEST(WeldBorders, FaceGivenTwiceIsWeldedOnce) {
  Soup twice = shapes::cube();
  twice.triangles.push_back(twice.triangles[3]);
  const Soup mended = welded(unwelded(twice), 0.0);
  SeamTopology expected = seam_topology_of(shapes::cube());
  // The later copy stays by itself.
  expected.vertices += 3;
  expected.edges += 3;
  expected.border_edges += 3;
  expected.faces += 1;
  expected.components += 1;
  EXPECT_EQ(seam_topology_of(mended), expected);
  EXPECT_EQ(mended.triangles.back(), (Triangle{8, 9, 10}));
}

TEST(WeldBorders, FacesBackToBackAreNotMadeDuplicates) {
  const Soup torn = unwelded(shapes::pillow());
  const PassRun run = run_pass(torn, weld(1e-3));
  EXPECT_EQ(run.operations, 0U);
  EXPECT_EQ(run.refused.size(), 3U);
}

TEST(WeldBorders, SheetsThatLieOnEachOtherAreRefused) {
  const Soup torn = shapes::merged(shapes::grid(2, 2), shapes::grid(2, 2));
  const PassRun run = run_pass(torn, weld(1e-3));
  EXPECT_EQ(run.operations, 0U);
  // The eight border edges of the one and those of the other.
  EXPECT_EQ(run.refused.size(), 8U);
}

TEST(WeldBorders, NarrowStripIsNotFoldedUp) {
  // Both long sides are within the tolerance of each other: joining them would leave no face.
  const Soup strip =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {1, 0.001, 0}, {0, 0.001, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const PassRun run = run_pass(strip, weld(0.01));
  EXPECT_EQ(run.operations, 0U);
  EXPECT_TRUE(same_soup(run.tracked.soup, strip));
}

TEST(WeldBorders, FaceThatWouldTurnOverKeepsItsVertices) {
  // The two sides are 0.1 apart, and the face below has its third corner in between: coming up to
  // y = 0, where most faces are, its upper side would pass that corner.
  Soup torn = shapes::make({{0, 0, 0},
                            {1, 0, 0},
                            {0.5, 1, 0},
                            {-0.5, 1, 0},
                            {1.5, 1, 0},
                            {0, 0.1, 0},
                            {1, 0.1, 0},
                            {0.5, 0.05, 0}},
                           {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {6, 5, 7}});
  const PassRun run = run_pass(torn, weld(0.15), any_distance());
  EXPECT_EQ(run.operations, 0U);
  ASSERT_FALSE(run.refused.empty());
  EXPECT_EQ(run.refused[0].reason, "joining them would turn a face over");
}

TEST(WeldBorders, BorderThatTouchesTheInsideIsNotWelded) {
  // A fin stands on an inner edge of a sheet, at the very place.
  Soup soup = shapes::grid(2, 2);
  const auto first = static_cast<Index>(soup.positions.size());
  soup.positions.emplace_back(1, 0, 0);
  soup.positions.emplace_back(1, 1, 0);
  soup.positions.emplace_back(1, 0.5, 1);
  soup.triangles.push_back({first, first + 1, first + 2});
  EXPECT_TRUE(same_soup(welded(soup, 0.1), soup));
}

TEST(WeldBorders, ToleranceLongerThanEdgesStillEnds) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const Soup torn = jittered(unwelded(shapes::icosphere(2)), 0.02, seed);
    const SeamTopology before = seam_topology_of(torn);
    const SeamTopology after = seam_topology_of(welded(torn, 0.5));
    EXPECT_LT(after.border_edges, before.border_edges);
    EXPECT_EQ(after.non_manifold_edges, 0U);
    EXPECT_EQ(after.duplicate_faces, 0U);
    EXPECT_GE(after.faces, before.faces);
  }
}

/// A quad split along the edge from u = (0,0,0) to v = (0,1,0), `lean` away from z = 0 on either
/// side, and a face on each of its edges at one side, that have border edges from u to (0,-1,0) and
/// from v to (0,2,0).
Soup quad_with_ears(double lean) {
  return shapes::make(
      {{0, 0, 0}, {0, 1, 0}, {lean, 0.5, 1}, {lean, 0.5, -1}, {0, -1, 0}, {0, 2, 0}},
      {{0, 1, 2}, {1, 0, 3}, {4, 0, 2}, {1, 5, 2}});
}

TEST(WeldBorders, EdgesAreNotJoinedOntoEdgesInside) {
  // The border edges of the ears are at one place. Joining them joins u and v of both, and so the
  // edges between, which have two faces each.
  const Soup torn = shapes::merged(quad_with_ears(1), shapes::flipped(quad_with_ears(-1)));
  const PassRun run = run_pass(torn, weld(1e-6));
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 2U);
  EXPECT_EQ(run.refused[0].reason, "joining them would make an edge with more than two faces");
}

TEST(WeldBorders, FacesNearlyBackToBackAreNotMadeDuplicates) {
  const Soup torn = jittered(unwelded(shapes::pillow()), 1e-4, 3);
  const PassRun run = run_pass(torn, weld(1e-3));
  EXPECT_EQ(run.operations, 0U);
  EXPECT_FALSE(run.refused.empty());
}

/// Meshes with much to weld, in all ways, and with what cannot be.
std::vector<Soup> torn_meshes() {
  std::vector<Soup> meshes;
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    std::mt19937 random(seed);
    Soup soup = unwelded(damaged(shapes::torus(3, 1, 12, 8), 12, random));
    // Some faces stay where they are, so that coincident borders and others are side by side.
    const Soup moved = jittered(soup, 0.01, seed);
    for (Index f = 0; f < soup.n_faces(); ++f) {
      if (below(random, 3) == 0) continue;
      for (const Index v : soup.triangles[f]) soup.positions[v] = moved.positions[v];
    }
    meshes.push_back(shapes::merged(soup, crack_with_junctions(0.001, {0.25, 0.5})));
  }
  return meshes;
}

TEST(WeldBorders, OperationsAreIndependent) {
  for (const Soup& torn : torn_meshes()) {
    TrackedMesh tracked = track_mesh(torn);
    for (std::uint32_t round = 0; round < 5; ++round) {
      const PreparedMesh mesh(tracked.soup);
      const RepairLimits limits = any_distance();
      const Edits edits = weld(0.05)({tracked.soup, tracked, mesh, {}, limits}).edits;
      if (edits.empty()) break;
      std::set<Index> faces;
      for (const Edits::ChangedFace& face : edits.changed_faces) {
        EXPECT_TRUE(faces.insert(face.face).second);
      }
      std::mt19937 random(round);
      std::vector<std::uint8_t> skipped(edits.n_operations);
      for (std::uint8_t& skip : skipped) skip = static_cast<std::uint8_t>(below(random, 2));
      const SeamTopology part = seam_topology_of(apply_edits(tracked, edits, skipped).soup);
      const SeamTopology before = seam_topology_of(tracked.soup);
      EXPECT_EQ(part.non_manifold_edges, before.non_manifold_edges);
      EXPECT_EQ(part.duplicate_faces, before.duplicate_faces);
      EXPECT_LE(part.non_manifold_vertices, before.non_manifold_vertices);
      tracked = apply_edits(tracked, edits);
      const SeamTopology after = seam_topology_of(tracked.soup);
      EXPECT_LT(after.border_edges, before.border_edges);
      EXPECT_EQ(after.non_manifold_edges, before.non_manifold_edges);
    }
  }
}

TEST(WeldBorders, DoneTwiceIsDoneOnce) {
  for (const Soup& torn : torn_meshes()) {
    const PassRun once = run_pass(torn, weld(0.05), any_distance());
    const PassRun twice = run_pass(once.tracked.soup, weld(0.05), any_distance());
    EXPECT_EQ(twice.operations, 0U);
    EXPECT_TRUE(same_soup(once.tracked.soup, twice.tracked.soup));
  }
}

TEST(WeldBorders, SolidsThatOverlapAtAnEdgeAreToldApartByTheirOtherEdges) {
  // In the order of their angle two faces that begin a solid, then two that end one.
  const Soup one = shapes::make({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  Soup other = one;
  for (Vec3& p : other.positions) p = Vec3(p.x() - p.y(), p.x() + p.y(), p.z());
  const Soup solids = shapes::merged(one, other);
  EXPECT_EQ(seam_topology_of(welded(unwelded(solids), 0.0)), seam_topology_of(solids));
}

TEST(WeldBorders, FacesOnOneSideOfAnEdgeAreNotJoined) {
  const Soup torn =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0.5, 2, 0}},
                   {{0, 1, 2}, {3, 4, 5}});
  const PassRun run = run_pass(torn, weld(0.0));
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].reason, "the faces lie on each other");
}

TEST(WeldBorders, NeedleIsNoSlit) {
  const Soup needle = shapes::make({{0, 0, 0}, {1, 0, 0}, {1, 0.001, 0}}, {{0, 1, 2}});
  const PassRun run = run_pass(needle, weld(0.01), any_distance());
  EXPECT_EQ(run.operations, 0U);
  EXPECT_TRUE(run.refused.empty());
}

TEST(WeldBorders, SlitIsZippedFromItsTips) {
  // The upper side is moved along the slit by more than half an edge, so that all its vertices but
  // the tips are nearer to a wrong one of the lower side.
  Soup torn = shapes::make({{0, 0, 0}, {6, 0, 0}, {3, 9, 0}, {3, -9, 0}}, {});
  for (const double x : {1, 2, 3, 4}) torn.positions.emplace_back(x + 0.6, 0.01, 0);
  for (const double x : {1, 2, 3, 4}) torn.positions.emplace_back(x, -0.01, 0);
  const std::vector<Index> upper{0, 4, 5, 6, 7, 1};
  const std::vector<Index> lower{0, 8, 9, 10, 11, 1};
  for (std::size_t i = 0; i < 5; ++i) {
    torn.triangles.push_back({upper[i], upper[i + 1], 2});
    torn.triangles.push_back({lower[i + 1], lower[i], 3});
  }
  const SeamTopology after = seam_topology_of(welded(torn, 1.5));
  EXPECT_EQ(after.border_edges, 4U);
  EXPECT_EQ(after.vertices, 8U);
}

TEST(WeldBorders, DegenerateFacesAreLeftOut) {
  Soup torn = unwelded(shapes::cube());
  const std::size_t n = torn.n_faces();
  // One without area on the place of an edge, one that repeats a vertex, one of a missing vertex.
  const auto first = static_cast<Index>(torn.positions.size());
  torn.positions.push_back(torn.positions[0]);
  torn.positions.push_back(torn.positions[1]);
  torn.positions.push_back(torn.positions[1]);
  torn.triangles.push_back({first, first + 1, first + 2});
  torn.triangles.push_back({0, 0, 1});
  torn.triangles.push_back({0, 1, kNoIndex});
  torn.missing.push_back({static_cast<Index>(n + 2), 2, 99});
  const PassRun run = run_pass(torn, weld(0.0), any_distance());
  EXPECT_TRUE(run.refused.empty());
  const Soup& mended = run.tracked.soup;
  const SeamTopology after = seam_topology_of(mended);
  EXPECT_EQ(after.border_edges, 3U);
  EXPECT_EQ(after.components, 2U);
  EXPECT_EQ(mended.n_faces(), n + 3);
}

TEST(WeldBorders, LongToleranceClosesWhatAShortOneDoes) {
  // Edges are 0.28 to 0.33 long; gaps 2e-5 at most.
  const Soup shape = shapes::icosphere(2);
  for (std::uint32_t seed = 0; seed < 4; seed += static_cast<std::uint32_t>(test::one_of())) {
    const Soup torn = jittered(unwelded(shape), 5e-6, seed);
    for (const double within : {2e-5, 1e-3, 0.05, 0.3, 1.0, 10.0}) {
      EXPECT_EQ(seam_topology_of(welded(torn, within)), seam_topology_of(shape)) << within;
    }
  }
}

TEST(WeldBorders, SliversWithOneTipEndInNoTime) {
  // Fans of a hundred thousand slivers, welded nowhere and farther apart than the tolerance, or
  // within it: none may be looked at with all others.
  const auto count = static_cast<Index>(100'000 / test::one_of());
  Soup torn;
  for (Index i = 0; i < count; ++i) {
    const double angle = 6.0 * i / count;
    const double next = angle + 3.0 / count;
    torn.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    torn.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    torn.positions.emplace_back(std::cos(next), std::sin(next), 0);
    torn.positions.emplace_back(0, 0, 1);
  }
  EXPECT_EQ(run_pass(torn, weld(1e-6), any_distance()).operations, 0U);
  EXPECT_EQ(run_pass(torn, weld(4.0 / count), any_distance()).operations, 1U);
}

TEST(WeldBorders, SizeOfTheMeshDoesNotMatter) {
  const Soup shape = shapes::icosphere(1);
  for (const double factor : {1e-300, 1e-160, 1e160, 1e300}) {
    const Soup torn = jittered(unwelded(shape), 0.001, 7);
    EXPECT_EQ(seam_topology_of(welded(shapes::scaled(torn, factor), 0.004 * factor)),
              seam_topology_of(shape))
        << factor;
  }
}

}  // namespace
}  // namespace meshalyzer
