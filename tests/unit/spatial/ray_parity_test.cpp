#include "meshalyzer/spatial/ray_parity.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <random>

namespace meshalyzer {
namespace {

PointLocation located(const Soup& soup, const Vec3& point) {
  const CutMesh cut = build(soup);
  const std::vector<Index> one_part(cut.mesh.n_faces(), 0);
  return locate(FaceTree(cut), {.of_face = one_part, .count = 1}, point);
}

bool is_inside(const Soup& soup, const Vec3& point) {
  const PointLocation place = located(soup, point);
  EXPECT_TRUE(place.on.empty());
  return !place.odd.empty();
}

TEST(Locate, PointsBehindAnEdgeOfTheCubeAreTold) {
  // The ray passes exactly through vertices, edges and diagonals of the far side.
  for (const double y : {0.0, 0.25, 0.5, 1.0}) {
    for (const double z : {0.0, 0.25, 0.5, 1.0}) {
      const bool inside = y > 0 && y < 1 && z > 0 && z < 1;
      if (inside) {
        EXPECT_TRUE(is_inside(shapes::cube(), {0.5, y, z}));
      }
      EXPECT_FALSE(is_inside(shapes::cube(), {-1, y, z}));
      EXPECT_FALSE(is_inside(shapes::cube(), {2, y, z}));
    }
  }
}

TEST(Locate, PointsOnTheSurfaceAreOnIt) {
  for (const Vec3& point :
       {Vec3(0, 0, 0), Vec3(1, 0.5, 0.5), Vec3(0.5, 0, 0.25), Vec3(0.5, 1, 1)}) {
    EXPECT_EQ(located(shapes::cube(), point).on, std::vector<Index>{0}) << point.transpose();
  }
}

TEST(Locate, NearestDoubleToTheSurfaceIsNotOnIt) {
  EXPECT_TRUE(is_inside(shapes::cube(), {std::nextafter(1.0, 0.0), 0.5, 0.5}));
  EXPECT_FALSE(is_inside(shapes::cube(), {std::nextafter(1.0, 2.0), 0.5, 0.5}));
}

TEST(Locate, LatticePointsOfATorusAgreeWithItsAlignedCopyTurnedRound) {
  // A body whose edges all lie on the rays: the slab with holes, of unit cubes at integer places.
  const Soup block = shapes::genus_block(3);
  for (int x = 0; x < 7; ++x) {
    for (int y = 0; y < 3; ++y) {
      const bool hole = x % 2 == 1 && y == 1;
      EXPECT_EQ(is_inside(block, {x + 0.5, y + 0.5, 0.5}), !hole) << x << " " << y;
    }
  }
}

TEST(Locate, RandomPointsOfASphereAgreeWithTheirDistance) {
  const Soup sphere = shapes::icosphere(3);
  std::mt19937 random(7);
  std::uniform_real_distribution<> real(-1.2, 1.2);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p(real(random), real(random), real(random));
    if (p.norm() < 0.98 || p.norm() > 1.0) {
      EXPECT_EQ(is_inside(sphere, p), p.norm() < 1) << p.transpose();
    }
  }
}

}  // namespace
}  // namespace meshalyzer
