#include "meshalyzer/repair/passes.h"
#include "support/effort.h"
#include "support/random_soups.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/overlapping_boxes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

using shapes::InnerShell;

/// Returns the result of the pass for a soup; a second run has nothing to do.
Soup outward(const Soup& soup) {
  const PassRun run = run_pass(soup, orient_outward);
  EXPECT_LE(run.rounds, 1U);
  EXPECT_TRUE(run.refused.empty());
  return run.tracked.soup;
}

/// Cubes about one centre, the outermost first, every other one a cavity.
Soup shells(int n) {
  Soup soup;
  for (int depth = 0; depth < n; ++depth) {
    const Soup shell = shapes::cube(2.0 * (n - depth), Vec3::Constant(depth));
    soup = shapes::merged(soup, depth % 2 == 0 ? shell : shapes::flipped(shell));
  }
  return soup;
}

/// All soups that come of turning some of `n` parts of `faces` faces each.
std::vector<Soup> with_parts_turned(const Soup& soup, Index n, Index faces) {
  std::vector<Soup> soups;
  for (Index choice = 0; choice < Index{1} << n; ++choice) {
    std::vector<Index> turned;
    for (Index f = 0; f < n * faces; ++f) {
      if ((choice >> (f / faces) & 1U) != 0) turned.push_back(f);
    }
    soups.push_back(shapes::flipped(soup, turned));
  }
  return soups;
}

/// The cube from -size / 2 to size / 2 without its top, which is two faces fewer.
Soup open_box(double size) {
  return shapes::scaled(shapes::translated(shapes::open_cube(), Vec3::Constant(-0.5)), size);
}

TEST(OrientOutward, MeshesThatPointTheRightWayAreLeft) {
  for (const Soup& soup : {Soup{}, shapes::cube(), shapes::open_cube(), shapes::torus(3, 1, 12, 8),
                           shells(3), shapes::two_tetrahedra_sharing_vertex(),
                           shapes::two_tetrahedra_sharing_edge(), shapes::icosphere(4)}) {
    EXPECT_TRUE(same_soup(outward(soup), soup));
  }
}

TEST(OrientOutward, ClosedMeshesInsideOutAreTurned) {
  for (const Soup& soup : {shapes::cube(), shapes::torus(3, 1, 12, 8), shapes::genus_block(2)}) {
    EXPECT_TRUE(same_soup(outward(shapes::flipped(soup)), soup));
  }
}

TEST(OrientOutward, NestedShellsAlternateHoweverTheyWereTurned) {
  for (const Soup& soup : with_parts_turned(shells(3), 3, 12)) {
    EXPECT_TRUE(same_soup(outward(soup), shells(3)));
  }
}

TEST(OrientOutward, CrossingCubesPointOutwardEach) {
  const Soup cubes = shapes::merged(shapes::cube(), shapes::cube(1.0, {0.5, 0.25, 0.125}));
  for (const Soup& soup : with_parts_turned(cubes, 2, 12)) {
    EXPECT_TRUE(same_soup(outward(soup), cubes));
  }
}

TEST(OrientOutward, ShellThatLiesOnTheOneRoundItIsTurnedWithThatOne) {
  const Soup overlapping = shapes::merged(shapes::cube(3), shapes::box({0, 0, 0}, {1, 1, 3}));
  for (const Soup& soup : {overlapping, cube_and_hole()}) {
    EXPECT_TRUE(same_soup(outward(soup), soup));
    EXPECT_TRUE(same_soup(outward(shapes::flipped(soup)), soup));
  }
}

TEST(OrientOutward, OpenBoxInsideOutIsTurned) {
  EXPECT_TRUE(same_soup(outward(shapes::flipped(shapes::open_cube())), shapes::open_cube()));
}

TEST(OrientOutward, SheetsAreLeftWhicheverWayTheyFace) {
  Soup waves = shapes::grid(12, 12);
  for (Vec3& p : waves.positions) p.z() = 0.3 * std::sin(p.x()) * std::cos(p.y());
  for (const Soup& soup : {shapes::grid(5, 5), waves, shapes::fan_of_three(), shapes::pillow(),
                           shapes::moebius_strip(9), shapes::klein_bottle(8, 8)}) {
    EXPECT_TRUE(same_soup(outward(soup), soup));
    EXPECT_TRUE(same_soup(outward(shapes::flipped(soup)), shapes::flipped(soup)));
  }
}

TEST(OrientOutward, ClosedMeshWithoutVolumeIsLeft) {
  Soup flat = shapes::cube();
  for (Vec3& p : flat.positions) p.z() = 0.0;
  EXPECT_TRUE(same_soup(outward(flat), flat));
}

TEST(OrientOutward, SolidsThatShareAVertexOrEdgeAreTurnedEachForItself) {
  for (const Soup& pair :
       {shapes::two_tetrahedra_sharing_vertex(), shapes::two_tetrahedra_sharing_edge()}) {
    for (const Soup& soup : with_parts_turned(pair, 2, 4)) {
      EXPECT_TRUE(same_soup(outward(soup), pair));
    }
  }
}

TEST(OrientOutward, OpenWallOfACavityStaysOne) {
  // In a closed box, and in one that is open itself.
  const Soup inner = shapes::flipped(open_box(1.0));
  const Soup in_closed = shapes::merged(shapes::cube(4.0, Vec3::Constant(-2.0)), inner);
  EXPECT_TRUE(same_soup(outward(in_closed), in_closed));
  const Soup in_open = shapes::merged(open_box(4.0), inner);
  for (const Soup& soup : with_parts_turned(in_open, 2, 10)) {
    EXPECT_TRUE(same_soup(outward(soup), in_open));
  }
}

TEST(OrientOutward, OpenWallThatReachesUpToTheOpeningRoundItIsACavity) {
  // Where the opening is near, the winding number of the outer box is between 1/2 and 3/4.
  Soup inner = shapes::flipped(open_box(1.0));
  for (Vec3& p : inner.positions) p.z() = p.z() < 0.0 ? -1.5 : 1.95;
  const Soup cup = shapes::merged(open_box(4.0), inner);
  EXPECT_TRUE(same_soup(outward(cup), cup));
}

TEST(OrientOutward, OpenWallThatTouchesTheOneRoundItIsACavity) {
  Soup inner = shapes::flipped(open_box(1.0));
  for (Vec3& p : inner.positions) p.z() = p.z() < 0.0 ? -2.0 : 0.0;
  const Soup in_open = shapes::merged(open_box(4.0), inner);
  EXPECT_TRUE(same_soup(outward(in_open), in_open));
  const Soup in_closed = shapes::merged(shapes::cube(4.0, Vec3::Constant(-2.0)), inner);
  EXPECT_TRUE(same_soup(outward(in_closed), in_closed));
}

TEST(OrientOutward, OpenBoxThatReachesOutOfAnotherIsNoCavity) {
  // They overlap by a corner that is too small for any sample to see.
  Soup spike = shapes::merged(shapes::cube(4.0, Vec3::Constant(-2.0)), open_box(1.0));
  spike.positions[8] = Vec3::Constant(-2.001);
  EXPECT_TRUE(same_soup(outward(spike), spike));
}

TEST(OrientOutward, SliverFarFromTheOriginMeansNoSolid) {
  // Its middle is off its plane by rounding.
  const Vec3 far(6506.57, 3700.01, 6398.83);
  for (const double width : {1e-3, 1e-6, 1e-9}) {
    const Soup sliver = shapes::make(
        {far, far + Vec3(0.17, 0.11, 0.37), far + Vec3(0.05, 0.04, 0.11) + Vec3::Constant(width)},
        {{0, 1, 2}});
    EXPECT_TRUE(same_soup(outward(sliver), sliver));
    EXPECT_TRUE(same_soup(outward(shapes::flipped(sliver)), shapes::flipped(sliver)));
  }
}

TEST(OrientOutward, OpenShellsAtOnePlaceAreNotInEachOther) {
  const Soup twice = shapes::merged(shapes::open_cube(), shapes::open_cube());
  EXPECT_TRUE(same_soup(outward(twice), twice));
  EXPECT_TRUE(same_soup(outward(shapes::flipped(twice)), twice));
}

TEST(OrientOutward, ComponentWithFlippedEdgesIsLeftForNow) {
  const Soup soup = shapes::flipped(shapes::flipped(shapes::cube()), std::array{Index{4}});
  EXPECT_TRUE(same_soup(outward(soup), soup));
}

TEST(OrientOutward, TurnedFacesOfASphereAreTurnedBackWithTheConsistentPassBefore) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    for (const Soup& soup : {shapes::icosphere(2), shapes::torus(3, 1, 16, 8), shells(2)}) {
      std::vector<Index> turned = shapes::permutation(soup.n_faces(), seed);
      turned.resize(turned.size() * (seed + 1) / 11);
      const PassRun consistent = run_pass(shapes::flipped(soup, turned), orient_consistently);
      EXPECT_TRUE(same_soup(outward(consistent.tracked.soup), soup));
    }
  }
}

TEST(OrientOutward, HugeAndTinyMeshesAreTurnedToo) {
  for (const double size : {1e-310, 1e-160, 1e160, 1e306}) {
    for (const Soup& shape : {shapes::open_cube(), shapes::cube()}) {
      const Soup soup = shapes::scaled(shape, size);
      EXPECT_TRUE(same_soup(outward(shapes::flipped(soup)), soup));
    }
  }
}

TEST(OrientOutward, DamagedMeshesAreSettledInOneRound) {
  std::mt19937 random(11);
  for (std::size_t i = 0; i < 20; i += test::one_of()) {
    Soup soup = shapes::merged(damaged(shapes::icosphere(2), 20, random),
                               damaged(shapes::scaled(shapes::icosphere(2), 0.5), 20, random));
    soup = run_pass(soup, orient_consistently).tracked.soup;
    const Soup once = outward(soup);
    EXPECT_TRUE(same_soup(outward(once), once));
  }
}

/// Gives each face of a mesh one normal, which agrees with it or is opposed to it.
Soup with_face_normals(Soup soup, double sign) {
  soup.format = Format::Obj;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const auto [a, b, c] = corners_of(soup, f);
    soup.normals.emplace_back(sign * (b - a).cross(c - a));
    soup.corner_normals.push_back({f, f, f});
  }
  return soup;
}

TEST(OrientOutward, NormalsAreTurnedWithTheFacesIfTheyAgreedWithThem) {
  for (const double sign : {1.0, -1.0}) {
    const Soup turned = outward(with_face_normals(shapes::flipped(shapes::cube()), sign));
    for (Index f = 0; f < turned.n_faces(); ++f) {
      const auto [a, b, c] = corners_of(turned, f);
      for (const Index normal : turned.corner_normals[f]) {
        EXPECT_EQ(turned.normals[normal], (b - a).cross(c - a));
      }
    }
  }
}

}  // namespace
}  // namespace meshalyzer
