#include "meshalyzer/base/parallel.h"
#include "meshalyzer/repair/internal/pass_memory.h"
#include "meshalyzer/repair/passes.h"
#include "support/effort.h"
#include "support/shapes.h"
#include "unit/repair/holes/hole_cases.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using Polygon = std::vector<std::array<double, 2>>;

constexpr FillOptions kAll{.sheets = FillSheets::Yes};
constexpr FillOptions kSmooth{.shape = FillShape::Smooth, .sheets = FillSheets::Yes};

/// A comb with n teeth: a bar 2 n - 1 by 1, and below it teeth of 1 by 5.
Polygon comb(int n) {
  Polygon polygon;
  for (int i = 0; i < n; ++i) {
    polygon.push_back({2.0 * i, 0.0});
    polygon.push_back({2.0 * i + 1.0, 0.0});
    if (i + 1 == n) break;
    polygon.push_back({2.0 * i + 1.0, 5.0});
    polygon.push_back({2.0 * i + 2.0, 5.0});
  }
  polygon.push_back({2.0 * n - 1.0, 6.0});
  polygon.push_back({0.0, 6.0});
  return polygon;
}

Polygon regular(std::size_t n) {
  Polygon polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    polygon.push_back({std::cos(a), std::sin(a)});
  }
  return polygon;
}

/// A sphere without the faces all of whose corners are above a height.
Soup without_cap(const Soup& sphere, double height) {
  std::vector<Index> cap;
  for (Index f = 0; f < sphere.n_faces(); ++f) {
    const Triangle& t = sphere.triangles[f];
    if (std::all_of(t.begin(), t.end(),
                    [&](Index v) { return sphere.positions[v].z() > height; })) {
      cap.push_back(f);
    }
  }
  return shapes::without_faces(sphere, cap);
}

TEST(FillHoles, ClosesAnOpenCubeWithTwoTriangles) {
  const Soup open = shapes::open_cube();
  const PassRun run = fill(open, {});
  expect_filled(run.tracked.soup);
  EXPECT_EQ(run.tracked.soup.n_faces(), open.n_faces() + 2);
  EXPECT_DOUBLE_EQ(area_of_patches(run.tracked), 1.0);
  EXPECT_TRUE(keeps_input(open, run.tracked));
}

TEST(FillHoles, LeavesAClosedMeshAlone) {
  const PassRun run = fill(shapes::icosphere(2), kAll);
  EXPECT_EQ(run.operations, 0U);
  EXPECT_TRUE(run.refused.empty());
}

TEST(FillHoles, HasNothingToDoForAnEmptyMesh) {
  EXPECT_EQ(fill(Soup{}, kAll).operations, 0U);
}

TEST(FillHoles, ProposesNothingForWhatItFilled) {
  const PassRun once = fill(shapes::open_cube(), kAll);
  const PassRun twice = fill(once.tracked.soup, kAll);
  EXPECT_EQ(twice.operations, 0U);
  EXPECT_TRUE(same_soup(once.tracked.soup, twice.tracked.soup));
}

TEST(FillHoles, PutsOneTriangleIntoThreeEdges) {
  for (Index face = 0; face < 4; ++face) {
    const std::array gone{face};
    const PassRun run = fill(shapes::without_faces(shapes::tetrahedron(), gone), kAll);
    expect_filled(run.tracked.soup);
    EXPECT_EQ(run.tracked.soup.n_faces(), 4U);
  }
}

TEST(FillHoles, NeverLaysAFaceOnAnother) {
  // The loop of a lone face could only be filled with the same face turned over.
  const std::array gone{Index{1}, Index{2}, Index{3}};
  const PassRun run = fill(shapes::without_faces(shapes::tetrahedron(), gone), kAll);
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].reason, "every patch tried intersects the mesh");
}

/// A bowl with the open rim 0 1 2 3, of which 1 and 3 are higher; and flaps inside and above it
/// that have edges across the rim.
Soup bowl_with_flaps(std::size_t n_flaps) {
  std::vector<Triangle> faces{{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
  if (n_flaps > 0) faces.push_back({0, 2, 5});
  if (n_flaps > 1) faces.push_back({1, 3, 6});
  return shapes::make({Vec3(0, 0, 0), Vec3(1, 0, 0.3), Vec3(1, 1, 0), Vec3(0, 1, 0.3),
                       Vec3(0.5, 0.5, -1), Vec3(0.5, 0.5, -0.5), Vec3(0.5, 0.5, 2)},
                      std::move(faces));
}

TEST(FillHoles, MakesNoEdgeThatTheMeshHas) {
  const PassRun run = fill(bowl_with_flaps(1), kAll);
  // Across the rim it is 1 to 3 then.
  ASSERT_EQ(run.tracked.soup.n_faces(), 7U);
  EXPECT_EQ(run.tracked.soup.n_vertices(), 7U);
  EXPECT_EQ(analyze(run.tracked.soup, "").characteristics.non_manifold_edges, 0U);
}

TEST(FillHoles, AddsAVertexWhereTheMeshHasAllEdgesAcross) {
  const PassRun run = fill(bowl_with_flaps(2), kAll);
  ASSERT_EQ(run.tracked.soup.n_faces(), 10U);
  EXPECT_EQ(run.tracked.soup.n_vertices(), 8U);
  EXPECT_EQ(analyze(run.tracked.soup, "").characteristics.non_manifold_edges, 0U);
  EXPECT_EQ(analyze(run.tracked.soup, "").characteristics.intersecting_pairs, 0U);
}

TEST(FillHoles, FillsAnLExactly) {
  const Polygon l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const PassRun run = fill(prism_wall({l}), kAll);
  expect_filled(run.tracked.soup);
  // Top and bottom, three unit squares each.
  EXPECT_DOUBLE_EQ(area_of_patches(run.tracked), 6.0);
}

TEST(FillHoles, FillsACombExactly) {
  const PassRun run = fill(prism_wall({comb(10)}), kAll);
  expect_filled(run.tracked.soup);
  // Ten teeth of 5 and a bar of 19, top and bottom.
  EXPECT_DOUBLE_EQ(area_of_patches(run.tracked), 2.0 * (50.0 + 19.0));
}

TEST(FillHoles, AvoidsTrianglesOfZeroAreaAlongStraightBorders) {
  // A square with ten vertices in line on each side.
  Polygon square;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < 10; ++i) {
      const double t = 0.1 * i;
      const std::array<std::array<double, 2>, 4> points{
          {{t, 0.0}, {1.0, t}, {1.0 - t, 1.0}, {0.0, 1.0 - t}}};
      square.push_back(points[static_cast<std::size_t>(side)]);
    }
  }
  const PassRun run = fill(prism_wall({square}), kAll);
  expect_filled(run.tracked.soup);
  EXPECT_NEAR(area_of_patches(run.tracked), 2.0, 1e-12);
}

TEST(FillHoles, GivesATubeTwoCaps) {
  const PassRun run = fill(prism_wall({regular(12)}), kAll);
  expect_filled(run.tracked.soup);
  EXPECT_EQ(run.operations, 2U);
  EXPECT_EQ(euler_characteristic(run.tracked.soup), 2);
}

TEST(FillHoles, LeavesTheBoresOfAPlateOpen) {
  const Polygon plate{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Polygon bore{{1, 1}, {1, 2}, {2, 2}, {2, 1}};
  const Polygon small_bore{{3, 3}, {3, 3.5}, {3.5, 3.5}, {3.5, 3}};
  const PassRun run = fill(prism_wall({plate, bore, small_bore}), kAll);
  expect_filled(run.tracked.soup);
  // 16 less the bores' 1 and 1/4, above and below; two tunnels make it of genus 2.
  EXPECT_DOUBLE_EQ(area_of_patches(run.tracked), 2.0 * (16.0 - 1.25));
  EXPECT_EQ(euler_characteristic(run.tracked.soup), -2);
}

TEST(FillHoles, FillsRoundAnIsland) {
  // A cube open at the top, and in the plane of its top a square of two faces that hangs on
  // nothing.
  const Soup island = shapes::make(
      {Vec3(0.25, 0.25, 1), Vec3(0.75, 0.25, 1), Vec3(0.75, 0.75, 1), Vec3(0.25, 0.75, 1)},
      {{0, 1, 2}, {0, 2, 3}});
  const Soup open = shapes::merged(shapes::open_cube(), island);
  const PassRun run = fill(open, {});
  expect_filled(run.tracked.soup);
  EXPECT_DOUBLE_EQ(area_of_patches(run.tracked), 1.0 - 0.25);
  EXPECT_TRUE(keeps_input(open, run.tracked));
}

TEST(FillHoles, FillsASaddle) {
  // The rims of a tube, bent: z = cos(2 angle).
  Soup open = prism_wall({regular(40)});
  for (Vec3& p : open.positions) p.z() += p.x() * p.x() - p.y() * p.y();
  const PassRun run = fill(open, kAll);
  expect_filled(run.tracked.soup);
  EXPECT_TRUE(keeps_input(open, run.tracked));
}

TEST(FillHoles, ClosesASphereWhereverFacesWereTakenOut) {
  std::mt19937 random(7);
  for (std::size_t trial = 0; trial < 40; ++trial) {
    SCOPED_TRACE(trial);
    const Soup open = punched(shapes::icosphere(2), 1 + trial % 4, random);
    const PassRun run = fill(open, trial % 2 == 0 ? kAll : kSmooth);
    expect_filled(run.tracked.soup);
    EXPECT_TRUE(keeps_input(open, run.tracked));
    // Orphans are no vertices of the surface: count them out.
    const auto orphans =
        static_cast<std::int64_t>(analyze(run.tracked.soup, "").integrity.orphan_vertices);
    EXPECT_EQ(euler_characteristic(run.tracked.soup) - orphans, 2);
  }
}

TEST(FillHoles, TakesOneOfTwoHolesThatTouchAfterTheOther) {
  // Faces on both sides of one vertex of the sphere go: two holes that meet there, one boundary.
  const Soup sphere = shapes::uv_sphere(8, 12);
  std::vector<Index> at_vertex;
  for (Index f = 0; f < sphere.n_faces(); ++f) {
    const Triangle& t = sphere.triangles[f];
    if (std::find(t.begin(), t.end(), Index{40}) != t.end()) at_vertex.push_back(f);
  }
  ASSERT_EQ(at_vertex.size(), 6U);
  // These are two of six faces round a vertex that have only the vertex in common.
  std::vector<Index> gone{at_vertex[0]};
  for (const Index f : at_vertex) {
    const Triangle& a = sphere.triangles[at_vertex[0]];
    const Triangle& b = sphere.triangles[f];
    const auto n_common = std::count_if(
        a.begin(), a.end(), [&](Index v) { return std::find(b.begin(), b.end(), v) != b.end(); });
    if (n_common == 1 && gone.size() == 1) gone.push_back(f);
  }
  const PassRun run = fill(shapes::without_faces(sphere, gone), kAll);
  expect_filled(run.tracked.soup);
  EXPECT_EQ(run.rounds, 2U);
}

TEST(FillHoles, AnyNumberOfThreadsFillsTheSame) {
  // Holes of all sizes, many of which touch, in walls that face each other.
  std::mt19937 random(7);
  Soup open;
  for (std::size_t k = 0; k < 16; ++k) {
    const Soup wall = shapes::scaled(shapes::icosphere(2), 1.0 - 0.02 * static_cast<double>(k));
    open = shapes::merged(open, punched(k % 2 == 0 ? wall : shapes::flipped(wall), 4, random));
  }
  const auto run = [&](std::size_t n_threads) {
    const ThreadLimit limit(n_threads);
    PassMemory memory;
    return run_pass(open, remembering(memory, hole_filling(kAll)));
  };
  const PassRun one = run(1);
  EXPECT_GT(one.operations, 40U);
  for (const std::size_t n_threads : {2U, 7U}) {
    const PassRun many = run(n_threads);
    EXPECT_TRUE(same_soup(many.tracked.soup, one.tracked.soup));
    EXPECT_EQ(many.operations, one.operations);
  }
}

TEST(FillHoles, SmoothPatchGoesOnAsTheSphereDoes) {
  const Soup open = without_cap(shapes::icosphere(4), 0.8);
  const PassRun run = fill(open, kSmooth);
  expect_filled(run.tracked.soup);
  ASSERT_GT(run.tracked.soup.n_vertices(), open.n_vertices());
  // The cap is 1 - 0.8 high, and so far a flat patch is from the sphere; a fair one is not the
  // sphere, but less than a tenth as far.
  for (std::size_t v = open.n_vertices(); v < run.tracked.soup.n_vertices(); ++v) {
    EXPECT_NEAR(run.tracked.soup.positions[v].norm(), 1.0, 0.02);
  }
}

TEST(FillHoles, SmoothPatchIsAboutAsDenseAsItsSurroundings) {
  const Soup sphere = shapes::icosphere(4);
  const Soup open = without_cap(sphere, 0.8);
  const std::size_t n_lost = sphere.n_faces() - open.n_faces();
  const std::size_t n_added = fill(open, kSmooth).tracked.soup.n_faces() - open.n_faces();
  EXPECT_GT(2 * n_added, n_lost);
  EXPECT_LT(n_added, 2 * n_lost);
}

TEST(FillHoles, SmoothPatchOfAFlatHoleIsFlat) {
  Soup box = shapes::merged(shapes::grid(8, 8), {});
  std::vector<Index> gone;
  for (Index f = 0; f < box.n_faces(); ++f) {
    const Triangle& t = box.triangles[f];
    const Vec3 middle = (box.positions[t[0]] + box.positions[t[1]] + box.positions[t[2]]) / 3.0;
    if ((middle - Vec3(4, 4, 0)).cwiseAbs().maxCoeff() < 2.0) gone.push_back(f);
  }
  const Soup open = shapes::without_faces(box, gone);
  const PassRun run =
      fill(open, {.at = Vec3(4, 4, 0), .shape = FillShape::Smooth, .sheets = FillSheets::Yes});
  EXPECT_EQ(run.operations, 1U);
  EXPECT_NEAR(area_of_patches(run.tracked), 16.0, 1e-9);
  EXPECT_EQ(analyze(run.tracked.soup, "").characteristics.intersecting_pairs, 0U);
}

TEST(FillHoles, FillsALoopOfManyEdges) {
  const PassRun run = fill(prism_wall({regular(20'000 / test::one_of())}), kAll);
  const Analysis found = analyze(run.tracked.soup, "");
  EXPECT_EQ(found.attributes.closed.value, true);
  EXPECT_EQ(found.characteristics.intersecting_pairs, 0U);
  // Twice the area of the regular polygon, n / 2 sin(2 pi / n), which is pi to six digits for 3,333
  // edges.
  EXPECT_NEAR(area_of_patches(run.tracked), 2.0 * std::numbers::pi, 1e-5);
}

TEST(FillHoles, LeavesASheetOpen) {
  const PassRun run = fill(shapes::grid(3, 3), {});
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].reason,
            "the surface is a sheet: it is left open unless hole filling is asked for by name");
  EXPECT_EQ(run.refused[0].vertex, 0U);
}

TEST(FillHoles, FillsASheetThatIsAskedForByName) {
  // The lowest quarter of a sphere by height goes round too little to be a solid.
  const Soup bowl = without_cap(shapes::icosphere(3), -0.5);
  EXPECT_EQ(fill(bowl, {}).operations, 0U);
  EXPECT_EQ(fill(bowl, kAll).operations, 1U);
  expect_filled(fill(bowl, kAll).tracked.soup);
}

TEST(FillHoles, FillsOnlyLoopsThatAreShortEnough) {
  const Soup tube = shapes::merged(prism_wall({regular(12)}),
                                   shapes::translated(prism_wall({regular(8)}), Vec3(5, 0, 0)));
  const PassRun run = fill(tube, {.max_edges = 8, .sheets = FillSheets::Yes});
  EXPECT_EQ(run.operations, 2U);
  EXPECT_EQ(analyze(run.tracked.soup, "").characteristics.boundaries, 2U);
}

TEST(FillHoles, FillsOnlyTheLoopNearestToAPoint) {
  const Soup tube = prism_wall({regular(12)});
  const PassRun run = fill(tube, {.at = Vec3(0, 0, 3), .sheets = FillSheets::Yes});
  ASSERT_EQ(run.operations, 1U);
  for (Index f = 0; f < run.tracked.soup.n_faces(); ++f) {
    if (run.tracked.origin_of_face(f) != kNoIndex) continue;
    for (const Index v : run.tracked.soup.triangles[f]) {
      EXPECT_EQ(run.tracked.soup.positions[v].z(), 1.0);
    }
  }
}

TEST(FillHoles, RefusesALoopOfFacesThatPointBothWays) {
  const std::array turned{Index{0}, Index{1}};
  const Soup open = shapes::flipped(prism_wall({regular(6)}), turned);
  const PassRun run = fill(open, kAll);
  EXPECT_EQ(run.operations, 0U);
  ASSERT_FALSE(run.refused.empty());
  EXPECT_EQ(run.refused[0].reason, "the faces round it are not oriented consistently");
}

TEST(FillHoles, RefusesABorderThatEndsAtANonManifoldEdge) {
  const PassRun run = fill(shapes::fan_of_three(), kAll);
  EXPECT_EQ(run.operations, 0U);
  EXPECT_EQ(run.refused.size(), 3U);
}

TEST(FillHoles, GoesRoundWhatIsInTheWay) {
  // Two corners of the upper rim are higher: a patch is a valley or a ridge, at height 1 or 1.4 in
  // the middle. A little tetrahedron stands in the way of the one or the other.
  Soup open = prism_wall({Polygon{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  open.positions[3].z() = 1.4;
  open.positions[7].z() = 1.4;
  for (const double height : {1.0, 1.4}) {
    SCOPED_TRACE(height);
    const Soup thorn = shapes::translated(shapes::scaled(shapes::tetrahedron(), 0.1),
                                          Vec3(0.48, 0.48, height - 0.05));
    const PassRun run = fill(shapes::merged(open, thorn), kAll);
    expect_filled(run.tracked.soup);
    EXPECT_EQ(run.tracked.soup.n_faces(), open.n_faces() + thorn.n_faces() + 4);
  }
}

/// A tent of 24 sides over an open rim, of which two vertices lie far out.
Soup tent_with_far_rim() {
  constexpr Index kSides = 24;
  Soup tent;
  for (Index i = 0; i < kSides; ++i) {
    const double a = 2.0 * std::numbers::pi * i / kSides;
    tent.positions.emplace_back(std::cos(a), std::sin(a), 0.2 * std::cos(2.0 * a));
  }
  for (Index i = 0; i < kSides; ++i) {
    const Vec3& p = tent.positions[i];
    tent.positions.emplace_back(0.9 * p.x(), 0.9 * p.y(), p.z() + 0.5);
  }
  tent.positions.emplace_back(0.0, 0.0, 1.0);
  for (Index a = 0; a < kSides; ++a) {
    const Index b = (a + 1) % kSides;
    const Index c = a + kSides;
    const Index d = b + kSides;
    for (const Triangle& t : {Triangle{a, b, d}, Triangle{a, d, c}, Triangle{c, d, 2 * kSides}}) {
      tent.triangles.push_back(t);
    }
  }
  tent.positions[4].x() = -1e155;
  tent.positions[14].y() = -1e155;
  return tent;
}

// The patch has vertices with thousands of edges, for which fairing would take a minute.
TEST(FillHoles, PatchOfARimThatReachesFarOutIsNotFaired) {
  const Soup open = tent_with_far_rim();
  EXPECT_EQ(fill(open, kSmooth).tracked.soup.n_vertices(), open.n_vertices());
}

TEST(FillHoles, CopesWithHugeAndTinyCoordinates) {
  for (const double scale : {1e-300, 1e-150, 1e150, 1e300}) {
    SCOPED_TRACE(scale);
    const PassRun run = fill(shapes::scaled(shapes::open_cube(), scale), kAll);
    EXPECT_EQ(run.tracked.soup.n_faces(), 12U);
  }
}

TEST(FillHoles, CopesWithAnySoup) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 30; ++trial) {
    const Soup soup = damaged(shapes::icosphere(1), 6, random);
    const PassRun run = fill(soup, trial % 2 == 0 ? kAll : kSmooth);
    EXPECT_TRUE(keeps_input(soup, run.tracked));
    EXPECT_LE(analyze(run.tracked.soup, "").characteristics.intersecting_pairs,
              analyze(soup, "").characteristics.intersecting_pairs);
    EXPECT_LE(analyze(run.tracked.soup, "").characteristics.non_manifold_edges,
              analyze(soup, "").characteristics.non_manifold_edges);
  }
}

TEST(FillHoles, ALoneTriangleGetsNoBackThatDiffersOnlyByRounding) {
  // The middle of these corners, rounded, is not in their plane.
  const Soup soup =
      shapes::make({{0.1, 0.2, 0.3}, {0.7, 0.33, 0.11}, {0.29, 0.83, 0.57}}, {{0, 1, 2}});
  const PassRun run = run_pass(soup, hole_filling({.sheets = FillSheets::Yes}));
  EXPECT_EQ(run.operations, 0U);
}

}  // namespace
}  // namespace meshalyzer
