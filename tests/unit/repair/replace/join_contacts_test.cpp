#include "meshalyzer/mesh/build.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/join_points.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"
#include "unit/repair/split/split_passes.h"
#include "unit/repair/voxel_solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Two unit cubes, the second moved so that they touch.
Soup cubes_that_touch(const Vec3& at) {
  return shapes::merged(shapes::cube(), shapes::cube(1, at));
}

/// A rod is a sixteenth of the maximum deviation thick, which is a hundredth of the diagonal here.
double thickness_of_rods(const Soup& soup) {
  return 0.01 * box_of(soup).diagonal().norm() / 16;
}

TEST(JoinContacts, CubesThatTouchAtACornerBecomeOne) {
  const Soup cubes = cubes_that_touch({1, 1, 1});
  const PassRun run = run_pass(cubes, join_contacts);
  EXPECT_TRUE(is_good(run.tracked.soup));
  EXPECT_EQ(n_components(run.tracked.soup), 1U);
  EXPECT_EQ(run.operations, 1U);
  // The corners of a rod are up to 1.4 thicknesses from its middle.
  const double volume = volume_of(run.tracked.soup);
  EXPECT_GT(volume, 2);
  EXPECT_LT(volume, 2 + 12 * std::pow(thickness_of_rods(cubes), 3));
}

TEST(JoinContacts, CubesThatTouchAlongAnEdgeBecomeOne) {
  const Soup cubes = cubes_that_touch({1, 1, 0});
  const PassRun run = run_pass(cubes, join_contacts);
  EXPECT_TRUE(is_good(run.tracked.soup));
  EXPECT_EQ(n_components(run.tracked.soup), 1U);
  // The rod is along all of the edge, of length 1, with a section of 1.29 squares of its thickness,
  // of which the cubes leave some, and about one thickness longer at each end.
  const double t = thickness_of_rods(cubes);
  const double volume = volume_of(run.tracked.soup);
  EXPECT_GT(volume, 2 + 0.2 * t * t);
  EXPECT_LT(volume, 2 + 1.29 * t * t * (1 + 2 * t));
}

TEST(JoinContacts, FacesAwayFromTheContactStayAsTheyAre) {
  const Soup cubes = cubes_that_touch({1, 1, 1});
  const PassRun run = run_pass(cubes, join_contacts);
  std::size_t n_old = 0;
  for (const Index key : run.tracked.face_keys) n_old += key < cubes.n_faces() ? 1 : 0;
  // At a corner of a cube there are at least three faces and at most six, of twelve.
  EXPECT_GE(n_old, 2U * 6);
  EXPECT_LE(n_old, 2U * 9);
}

TEST(JoinContacts, RandomVoxelsBecomeManifold) {
  std::mt19937 random(7);
  for (int n = 0; n < 12; ++n) {
    VoxelSolid solid({3, 3, 3});
    solid.fill({0, 0, 0});
    solid.fill({1, 1, 0});
    for (int cell = 0; cell < 27; ++cell) {
      if (random() % 2 == 0) solid.fill({cell % 3, cell / 3 % 3, cell / 9});
    }
    const Soup split_up = split(solid.surface()).tracked.soup;
    if (n_intersecting_pairs(split_up) == 0) continue;
    EXPECT_TRUE(is_good(run_pass(split_up, join_contacts).tracked.soup)) << n;
  }
}

TEST(JoinContacts, OnlyContactsOfClosedMeshesAreJoined) {
  const Soup touching = cubes_that_touch({1, 1, 1});
  const Soup crossing = shapes::merged(touching, shapes::cube(1, {0.5, 0.25, 0.125}));
  const Soup open = shapes::without_faces(touching, std::vector<Index>{0});
  for (const Soup& soup : {shapes::cube(), crossing, open, Soup{}}) {
    EXPECT_TRUE(same_soup(run_pass(soup, join_contacts).tracked.soup, soup));
  }
}

TEST(JoinContacts, WithoutDeviationNothingIsJoined) {
  const Soup cubes = cubes_that_touch({1, 1, 1});
  const RepairLimits limits{.max_deviation = 0.0, .fixed_vertices = {}};
  EXPECT_TRUE(same_soup(run_pass(cubes, join_contacts, limits).tracked.soup, cubes));
}

/// Spikes with their tips at the origin, one in each octant, with this vertex in common.
Soup spikes_at_the_origin() {
  Soup soup = shapes::make({{0, 0, 0}}, {});
  for (int octant = 0; octant < 8; ++octant) {
    const Vec3 signs(octant % 2 == 0 ? 1 : -1, octant / 2 % 2 == 0 ? 1 : -1,
                     octant / 4 == 0 ? 1 : -1);
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Vec3& p : {Vec3(3, 1, 1), Vec3(1, 3, 1), Vec3(1, 1, 3)}) {
      soup.positions.emplace_back(p.cwiseProduct(signs));
    }
    std::vector<Triangle> faces{{0, first + 1, first},
                                {0, first + 2, first + 1},
                                {0, first, first + 2},
                                {first, first + 1, first + 2}};
    if (signs.prod() < 0) {
      for (Triangle& t : faces) std::swap(t[1], t[2]);
    }
    soup.triangles.insert(soup.triangles.end(), faces.begin(), faces.end());
  }
  return soup;
}

/// Runs a pass once, which does not see what it has done and would do it again.
PassRun run_once(const Soup& soup, const PassFunction& pass) {
  bool has_run = false;
  return run_pass(soup, [&](const PassInput& input) {
    return std::exchange(has_run, true) ? PassResult{} : pass(input);
  });
}

TEST(JoinAtPoints, ASmallSolidTakesThePlaceOfAVertexOfManyParts) {
  const Soup spikes = spikes_at_the_origin();
  ASSERT_EQ(build(spikes).side.non_manifold_vertices.size(), 1U);
  const std::vector<Vec3> points{Vec3(0, 0, 0)};
  const PassRun run =
      run_once(spikes, [&](const PassInput& input) { return join_at_points(input, points); });
  EXPECT_TRUE(is_good(run.tracked.soup));
  EXPECT_EQ(n_components(run.tracked.soup), 1U);
  const double volume = volume_of(run.tracked.soup);
  EXPECT_GT(volume, volume_of(spikes));
  EXPECT_LT(volume, volume_of(spikes) + 6 * std::pow(thickness_of_rods(spikes), 3));
}

TEST(JoinAtPoints, WithoutPointsNothingIsJoined) {
  const Soup spikes = spikes_at_the_origin();
  const PassRun run =
      run_pass(spikes, [&](const PassInput& input) { return join_at_points(input, {}); });
  EXPECT_TRUE(same_soup(run.tracked.soup, spikes));
}

TEST(ContactPoints, AreWhereFacesTouchAtCopiesOfVertices) {
  const Soup split_up = split(spikes_at_the_origin()).tracked.soup;
  EXPECT_EQ(contact_points(track_mesh(split_up), PreparedMesh(split_up)),
            std::vector<Vec3>{Vec3(0, 0, 0)});
}

TEST(ContactPoints, AreNoneWhereSomethingElseIsWrong) {
  const Soup split_up = split(spikes_at_the_origin()).tracked.soup;
  const Soup crossing = shapes::merged(split_up, shapes::translated(split_up, {0.5, 0.25, 0.125}));
  const Soup open = shapes::without_faces(split_up, std::vector<Index>{3});
  for (const Soup& soup : {shapes::cube(), crossing, open}) {
    EXPECT_TRUE(contact_points(track_mesh(soup), PreparedMesh(soup)).empty());
  }
}

}  // namespace
}  // namespace meshalyzer
