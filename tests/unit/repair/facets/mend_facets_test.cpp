#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/spatial/closest_point.h"
#include "support/effort.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/facets/mended_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

/// One round.
PassResult mend_once(const Soup& soup, const RepairLimits& limits) {
  const TrackedMesh tracked = track_mesh(soup);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances = resolve_tolerances({}, box_of(soup));
  return mend_facets({tracked.soup, tracked, mesh, tolerances, limits});
}

/// The largest distance from the second surface of a lattice of points on each face of the first.
double sampled_distance(const Soup& from, const Soup& to) {
  constexpr int kSteps = 12;
  const PreparedMesh target(to);
  const ClosestPoints closest(target.tree());
  double largest = 0.0;
  for (const Triangle& t : from.triangles) {
    if (!is_in_complex(t)) continue;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const Vec3 p = (i * from.positions[t[0]] + j * from.positions[t[1]] +
                        (kSteps - i - j) * from.positions[t[2]]) /
                       kSteps;
        largest = std::max(largest, closest.find({.point = p})->distance);
      }
    }
  }
  return largest;
}

/// A square of four faces round (0, 0), one of its sides bent outwards to `tip` by a fifth.
Soup star_with_cap(const Vec3& tip) {
  return shapes::make({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0}, tip},
                      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}});
}

/// The vertices of the faces that find_thin_facets() finds, by index.
std::vector<std::uint8_t> thin_vertices(const Soup& soup) {
  std::vector<std::uint8_t> is_thin(soup.n_vertices(), 0);
  for (const Index f : thin_faces(soup)) {
    for (const Index v : soup.triangles[f]) is_thin[v] = 1;
  }
  return is_thin;
}

/// Expects faces without a thin neighbour, and all places, to be what they were.
void expect_rest_untouched(const Soup& before, const TrackedMesh& after) {
  const std::vector<std::uint8_t> is_thin = thin_vertices(before);
  std::vector<Index> place(before.n_faces(), kNoIndex);
  for (Index i = 0; i < after.soup.n_faces(); ++i) {
    if (after.face_keys[i] < before.n_faces()) place[after.face_keys[i]] = i;
  }
  for (Index f = 0; f < before.n_faces(); ++f) {
    const Triangle& t = before.triangles[f];
    if (is_thin[t[0]] != 0 || is_thin[t[1]] != 0 || is_thin[t[2]] != 0) continue;
    ASSERT_NE(place[f], kNoIndex);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = after.soup.triangles[place[f]][k];
      EXPECT_EQ(after.vertex_keys[v], t[k]);
      EXPECT_EQ(std::memcmp(&after.soup.positions[v], &before.positions[t[k]], sizeof(Vec3)), 0);
    }
  }
}

/// Shapes of all kinds: closed, of higher genus, open, flat.
std::vector<Soup> sound_shapes() {
  return {shapes::icosphere(2), shapes::torus(3.0, 1.0, 16, 9), shapes::genus_block(2),
          shapes::grid(8, 8), shapes::open_cube()};
}

TEST(MendFacets, NothingIsProposedForSoundMeshes) {
  for (const Soup& soup : sound_shapes()) {
    const PassResult result = mend_once(soup, wide_limits(soup));
    EXPECT_TRUE(result.edits.empty());
    EXPECT_TRUE(result.refused.empty());
  }
}

TEST(MendFacets, FaceThatRepeatsAVertexIsDroppedAlone) {
  Soup soup = shapes::cube();
  soup.triangles.push_back({0, 1, 1});
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_TRUE(same_soup(run.tracked.soup, shapes::cube()));
}

TEST(MendFacets, NeedlesOfASplitEdgeGoWithTheirVertex) {
  Soup soup = shapes::icosphere(1);
  split_edge(soup, 7, 1, 1e-10);
  ASSERT_EQ(thin_faces(soup).size(), 2U);
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  EXPECT_EQ(run.tracked.soup.n_faces(), shapes::icosphere(1).n_faces());
  EXPECT_EQ(topology_of(run.tracked.soup), topology_of(soup));
}

TEST(MendFacets, EdgeJustAboveTheToleranceStays) {
  Soup soup = shapes::icosphere(1);
  // An edge of about 0.6, the diagonal about 3.5: the tolerance is 3.5e-8.
  split_edge(soup, 7, 1, 1e-6);
  ASSERT_TRUE(thin_faces(soup).empty());
  EXPECT_TRUE(same_soup(run_pass(soup, mend_facets).tracked.soup, soup));
}

TEST(MendFacets, FixedVertexKeepsItsPlaceWhenItsEdgeIsCollapsed) {
  Soup soup = shapes::icosphere(1);
  split_edge(soup, 7, 1, 1e-10);
  const auto added = static_cast<Index>(soup.n_vertices() - 1);
  RepairLimits limits = wide_limits(soup);
  limits.fixed_vertices.assign(soup.n_vertices(), 0);
  limits.fixed_vertices[added] = 1;
  const PassRun run = run_pass(soup, mend_facets, limits);
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  const auto& keys = run.tracked.vertex_keys;
  const auto place = std::find(keys.begin(), keys.end(), added);
  ASSERT_NE(place, keys.end());
  EXPECT_EQ(run.tracked.soup.positions[static_cast<std::size_t>(place - keys.begin())],
            soup.positions[added]);
}

TEST(MendFacets, EdgeOfTwoFixedVerticesIsRefused) {
  Soup soup = shapes::icosphere(1);
  split_edge(soup, 7, 1, 1e-10);
  RepairLimits limits = wide_limits(soup);
  limits.fixed_vertices.assign(soup.n_vertices(), 1);
  const PassRun run = run_pass(soup, mend_facets, limits);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  ASSERT_EQ(run.refused.size(), 2U);
  EXPECT_EQ(run.refused[0].reason, "its vertices have to stay where they are");
}

TEST(MendFacets, CapIsFlippedAndNoVertexLost) {
  Soup soup = shapes::cube();
  // In the middle of a side of the cube, on the edge of face 0 that begins at its corner 0.
  add_cap(soup, 0, 0, 0.5);
  ASSERT_EQ(thin_faces(soup), (std::vector<Index>{0}));
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  EXPECT_EQ(run.tracked.soup.n_faces(), soup.n_faces());
  EXPECT_EQ(run.tracked.soup.n_vertices(), soup.n_vertices());
  EXPECT_EQ(topology_of(run.tracked.soup), topology_of(soup));
}

TEST(MendFacets, CapAtABorderIsDroppedAndTheBorderRunsThroughItsApex) {
  Soup soup = shapes::grid(1, 1);
  const std::size_t border_corner = [&] {
    const Triangle& t = soup.triangles[0];
    for (std::size_t k = 0; k < 3; ++k) {
      if (face_crossing(soup, t[(k + 1) % 3], t[k]) == kNoIndex) return k;
    }
    return std::size_t{3};
  }();
  add_cap(soup, 0, border_corner, 0.5);
  ASSERT_EQ(thin_faces(soup).size(), 1U);
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  EXPECT_EQ(run.tracked.soup.n_faces(), soup.n_faces() - 1);
  EXPECT_EQ(run.tracked.soup.n_vertices(), soup.n_vertices());
  EXPECT_EQ(topology_of(run.tracked.soup), topology_of(soup));
}

TEST(MendFacets, CapAtANonManifoldEdgeSplitsAllOtherFaces) {
  Soup soup = shapes::fan_of_three();
  const Triangle& t = soup.triangles[0];
  std::size_t k = 0;
  while (!(t[k] + t[(k + 1) % 3] == 1)) ++k;
  add_cap(soup, 0, k, 0.5);
  ASSERT_EQ(thin_faces(soup).size(), 1U);
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  // The three faces of the fan are two each now.
  EXPECT_EQ(run.tracked.soup.n_faces(), 6U);
  EXPECT_EQ(topology_of(run.tracked.soup).euler_characteristic,
            topology_of(soup).euler_characteristic);
  EXPECT_EQ(topology_of(run.tracked.soup).boundaries, 3U);
}

TEST(MendFacets, CapBetweenGroupsLeavesItsHalvesToTheOtherGroup) {
  Soup soup = star_with_cap({0, -1, 0});
  soup.groups = {{"square", 0}, {"cap", 4}};
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  ASSERT_EQ(run.tracked.soup.n_faces(), 5U);
  EXPECT_EQ(group_of(run.tracked.soup, 4), 0U);
}

TEST(MendFacets, CapOnTheBorderOfAFaceOfABodyIsRefused) {
  Soup soup = star_with_cap({0, -1, 0});
  soup.groups = {{"square", 0}, {"cap", 4}};
  RepairLimits limits = wide_limits(soup);
  limits.groups = Groups::Faces;
  const PassRun run = run_pass(soup, mend_facets, limits);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  EXPECT_EQ(run.refused.size(), 1U);
}

TEST(MendFacets, NeckOfThreeShortEdgesIsNotPinched) {
  // A tube of two long halves on a triangle smaller than the tolerance: collapsing one of its edges
  // would tear the halves apart.
  const double r = 1e-10;
  const Soup soup = hourglass({Vec3{r, 0, 0}, Vec3{-r, r, 0}, Vec3{-r, -r, 0}});
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_EQ(topology_of(run.tracked.soup), topology_of(soup));
  EXPECT_FALSE(run.refused.empty());
}

/// Puts a vertex with three faces on a face, at a height above its middle.
void put_fin_on(Soup& soup, Index face, double height) {
  const Triangle t = soup.triangles[face];
  const Corners p = corners_of(soup, face);
  const auto tip = static_cast<Index>(soup.n_vertices());
  soup.positions.emplace_back(centroid_of(p) + height * normal_of(p).normalized());
  soup.triangles[face] = {t[0], t[1], tip};
  soup.triangles.push_back({t[1], t[2], tip});
  soup.triangles.push_back({t[2], t[0], tip});
}

TEST(MendFacets, FinsOnNeedlesGoWithThemAndTheTopologyStays) {
  constexpr double kHeight = 1e-3;
  for (Soup soup : {shapes::icosphere(2), shapes::torus(3.0, 1.0, 16, 9)}) {
    const TopologyCounts topology = topology_of(soup);
    for (Index face = 0; face < 280; face += 40) {
      split_edge(soup, face, face / 40 % 3, 1e-10);
      // The last two faces are needles: one of them gets a fin, or both.
      const auto last = static_cast<Index>(soup.n_faces() - 1);
      put_fin_on(soup, last, kHeight);
      if (face % 80 == 0) put_fin_on(soup, last - 1, kHeight);
    }
    ASSERT_FALSE(thin_faces(soup).empty());
    const PassRun run = run_pass(soup, mend_facets);
    EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
    EXPECT_EQ(topology_of(run.tracked.soup), topology);
    EXPECT_LE(sampled_distance(soup, run.tracked.soup), kHeight * (1.0 + 1e-6));
    EXPECT_LE(sampled_distance(run.tracked.soup, soup), kHeight);
  }
}

TEST(MendFacets, TriangularHoleWithAShortEdgeStaysAHole) {
  Soup soup = shapes::icosphere(1);
  split_edge(soup, 7, 1, 1e-10);
  const std::vector<Index> hole{thin_faces(soup).front()};
  soup = shapes::without_faces(soup, hole);
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_EQ(topology_of(run.tracked.soup), topology_of(soup));
  EXPECT_EQ(run.refused.size(), 1U);
}

TEST(MendFacets, ComponentOfFlatFacesAloneIsRefused) {
  Soup soup =
      shapes::merged(shapes::cube(), shapes::make({{3, 0, 0}, {4, 0, 0}, {5, 0, 0}}, {{0, 1, 2}}));
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].face, 12U);
  EXPECT_EQ(run.refused[0].reason,
            "all faces of its component are flat, and no other surface is where it is");
}

TEST(MendFacets, SpeckBesideTheSurfaceIsDroppedAndOneFarFromItRefused) {
  const Soup speck = shapes::scaled(shapes::tetrahedron(), 1e-10);
  // The diagonal is at most 5.2, so the deviation at most 0.052.
  for (const double x : {1.01, 2.0}) {
    const Soup soup = shapes::merged(shapes::cube(), shapes::translated(speck, {x, 0.5, 0.5}));
    const PassRun run = run_pass(soup, mend_facets);
    EXPECT_EQ(run.tracked.soup.n_faces(), x < 1.5 ? 12U : 16U);
    EXPECT_EQ(run.refused.size(), x < 1.5 ? 0U : 4U);
  }
}

TEST(MendFacets, FlatComponentOnTheSurfaceIsDropped) {
  // Along the diagonal of a side of the cube, and as long.
  const Soup soup =
      shapes::merged(shapes::cube(), shapes::make({{0, 0, 1}, {1, 1, 1}, {0, 0, 1}}, {{0, 1, 2}}));
  EXPECT_TRUE(same_soup(run_pass(soup, mend_facets).tracked.soup, shapes::cube()));
}

TEST(MendFacets, CapIsLeftWhereTheDeviationIsZeroAndItIsNot) {
  // 1e-9 high, below the tolerance of about 3e-8.
  const Soup soup = star_with_cap({0, -1 - 1e-9, 0});
  ASSERT_EQ(thin_faces(soup).size(), 1U);
  const PassRun run = run_pass(soup, mend_facets, {});
  EXPECT_TRUE(same_soup(run.tracked.soup, soup));
  EXPECT_EQ(run.refused.size(), 1U);
}

TEST(MendFacets, ZeroAreaFanIsFlippedAwayInOneRound) {
  // The triangle 0, n, n + 1 stands on n edges in line, which a fan of n - 1 faces without area
  // joins to it; the faces on the other side know all of them.
  constexpr Index kEdges = 50;
  Soup soup;
  for (Index i = 0; i <= kEdges; ++i) soup.positions.emplace_back(i, 0, 0);
  soup.positions.emplace_back(0, 30, 0);
  soup.positions.emplace_back(0, -30, 0);
  soup.triangles.push_back({0, kEdges, kEdges + 1});
  for (Index i = 1; i < kEdges; ++i) soup.triangles.push_back({0, i, i + 1});
  for (Index i = 0; i < kEdges; ++i) soup.triangles.push_back({i + 1, i, kEdges + 2});
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_EQ(run.rounds, 1U);
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  EXPECT_EQ(run.tracked.soup.n_vertices(), soup.n_vertices());
  EXPECT_EQ(topology_of(run.tracked.soup), topology_of(soup));
}

TEST(MendFacets, RandomNeedlesAndCapsAllGoAndNothingElseDoes) {
  std::mt19937 random(20);
  for (const Soup& shape : sound_shapes()) {
    for (std::size_t i = 0; i < 8; i += test::one_of()) {
      Soup soup = shape;
      hurt(soup, 12, random);
      const PassRun run = run_pass(soup, mend_facets);
      EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
      EXPECT_EQ(topology_of(run.tracked.soup), topology_of(soup));
      EXPECT_LE(run.rounds, 6U);
      expect_rest_untouched(soup, run.tracked);
      const double bound = wide_limits(soup).max_deviation;
      EXPECT_LE(sampled_distance(soup, run.tracked.soup), bound);
      EXPECT_LE(sampled_distance(run.tracked.soup, soup), bound);
      EXPECT_TRUE(mend_once(run.tracked.soup, wide_limits(run.tracked.soup)).edits.empty());
    }
  }
}

TEST(MendFacets, AnyOfTheOperationsMayBeLeftOut) {
  std::mt19937 random(21);
  for (const Soup& shape : sound_shapes()) {
    for (int i = 0; i < 10; ++i) {
      Soup soup = shape;
      hurt(soup, 40, random);
      const Edits edits = mend_once(soup, wide_limits(soup)).edits;
      std::vector<std::uint8_t> skipped(edits.n_operations);
      for (std::uint8_t& skip : skipped) skip = below(random, 2) == 0 ? 1 : 0;
      const TrackedMesh tracked = apply_edits(track_mesh(soup), edits, skipped);
      EXPECT_EQ(topology_of(tracked.soup), topology_of(soup));
      EXPECT_LT(thin_faces(tracked.soup).size(), thin_faces(soup).size());
    }
  }
}

TEST(MendFacets, ManyScatteredDefectsTakeFewRounds) {
  std::mt19937 random(22);
  Soup soup = shapes::icosphere(5);
  hurt(soup, 1000, random);
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  EXPECT_LE(run.rounds, 3U);
}

TEST(MendFacets, ClusterSmallerThanTheToleranceShrinksWithoutTearing) {
  Soup soup = shapes::icosphere(3);
  for (Vec3& p : soup.positions) {
    if (p.z() > 0.7) p = Vec3::UnitZ() + 1e-9 * (p - Vec3::UnitZ());
  }
  const PassRun run = run_pass(soup, mend_facets);
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  EXPECT_EQ(topology_of(run.tracked.soup), topology_of(soup));
}

/// Few vertices at few places, faces in any way: everything is wrong at once.
Soup any_soup(std::mt19937& random, double size) {
  Soup soup;
  const Index n_vertices = 3 + below(random, 12);
  for (Index v = 0; v < n_vertices; ++v) {
    soup.positions.emplace_back(size * below(random, 4), size * below(random, 4),
                                size * below(random, 3));
  }
  const Index n_faces = 1 + below(random, 40);
  for (Index f = 0; f < n_faces; ++f) {
    Triangle t{};
    for (Index& v : t) v = below(random, 40) == 0 ? kNoIndex : below(random, n_vertices);
    soup.triangles.push_back(t);
    for (std::uint8_t k = 0; k < 3; ++k) {
      if (t[k] == kNoIndex) soup.missing.push_back({f, k, 1000});
    }
  }
  return soup;
}

TEST(MendFacets, AnySoupOfAnySizeIsMendedToAnEnd) {
  std::mt19937 random(23);
  for (const double size : {1.0, 1e-300, 5e-324, 1e300, 5e307}) {
    for (int i = 0; i < 200; ++i) {
      const Soup soup = any_soup(random, size);
      RepairLimits limits = wide_limits(soup);
      limits.max_deviation = std::numeric_limits<double>::max();
      const PassRun run = run_pass(soup, mend_facets, limits);
      EXPECT_LE(thin_faces(run.tracked.soup).size(), thin_faces(soup).size());
    }
  }
}

}  // namespace
}  // namespace meshalyzer
