#include "meshalyzer/exact/exact_volume.h"

#include "random_points.h"
#include "support/rational_oracle.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::uint32_t kSeed = 20261121;

using Tetrahedron = std::array<Vec3, 4>;

/// The corners of the faces of a tetrahedron, outward where orient3d() of it is positive.
std::vector<Vec3> faces_of(const Tetrahedron& t) {
  return {t[0], t[2], t[1], t[0], t[1], t[3], t[0], t[3], t[2], t[1], t[2], t[3]};
}

Sign sign_of(const std::vector<Vec3>& corners) {
  ExactVolume volume;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    volume.add(corners[i], corners[i + 1], corners[i + 2]);
  }
  return volume.sign();
}

Tetrahedron random_tetrahedron(RandomPoints& points, Cloud cloud) {
  Tetrahedron t;
  for (Vec3& corner : t) corner = points.next(cloud);
  return t;
}

TEST(ExactVolume, NothingHasNoSign) {
  EXPECT_EQ(ExactVolume().sign(), 0);
}

TEST(ExactVolume, OutwardTetrahedronIsPositiveAndInwardNegative) {
  const Vec3 far(1e8, -1e8, 1e8);
  const Tetrahedron t{far, far + Vec3(1, 0, 0), far + Vec3(0, 1, 0), far + Vec3(0, 0, 1)};
  EXPECT_EQ(sign_of(faces_of(t)), 1);
  EXPECT_EQ(sign_of(faces_of({t[1], t[0], t[2], t[3]})), -1);
}

TEST(ExactVolume, TetrahedronHasTheSignOfItsOrientation) {
  // The faces of a tetrahedron sum up to the determinant that orient3d() is the sign of.
  for (const Cloud cloud : kClouds) {
    RandomPoints points(kSeed);
    for (int round = 0; round < 500 && !HasFailure(); ++round) {
      SCOPED_TRACE(testing::Message() << "cloud " << static_cast<int>(cloud) << " round " << round);
      const Tetrahedron t = random_tetrahedron(points, cloud);
      EXPECT_EQ(sign_of(faces_of(t)), test::rational_orient3d(t[0], t[1], t[2], t[3]));
    }
  }
}

TEST(ExactVolume, ManyTrianglesAgreeWithRationals) {
  for (const Cloud cloud : kClouds) {
    RandomPoints points(kSeed);
    for (int round = 0; round < 20 && !HasFailure(); ++round) {
      SCOPED_TRACE(testing::Message() << "cloud " << static_cast<int>(cloud) << " round " << round);
      std::vector<Vec3> corners;
      for (int i = 0; i < 30; ++i) corners.push_back(points.next(cloud));
      EXPECT_EQ(sign_of(corners), test::rational_volume_sign(corners));
    }
  }
}

TEST(ExactVolume, ShellThinnerThanRoundingKeepsItsSign) {
  // A fourth corner one bit above or below the plane z = x + y + 1/8 of the others.
  const double z = 0.25 + 0.5 + 0.125;
  const Tetrahedron above{Vec3(0, 0, 0.125), Vec3(1, 0, 1.125), Vec3(0, 1, 1.125),
                          Vec3(0.25, 0.5, std::nextafter(z, 2.0))};
  const Tetrahedron below{above[0], above[1], above[2], Vec3(0.25, 0.5, std::nextafter(z, 0.0))};
  const Tetrahedron within{above[0], above[1], above[2], Vec3(0.25, 0.5, z)};
  EXPECT_EQ(sign_of(faces_of(above)), 1);
  EXPECT_EQ(sign_of(faces_of(below)), -1);
  EXPECT_EQ(sign_of(faces_of(within)), 0);
}

TEST(ExactVolume, FacesBackToBackCancel) {
  RandomPoints points(kSeed);
  for (int round = 0; round < 200; ++round) {
    const Vec3 a = points.next(Cloud::BitPatterns);
    const Vec3 b = points.next(Cloud::BitPatterns);
    const Vec3 c = points.next(Cloud::BitPatterns);
    EXPECT_EQ(sign_of({a, b, c, a, c, b}), 0);
  }
}

TEST(ExactVolume, MovedSumGoesOnAdding) {
  ExactVolume first;
  first.add({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  ExactVolume second = std::move(first);
  EXPECT_EQ(second.sign(), 1);
  second.add({0, 2, 0}, {1, 0, 0}, {0, 0, 1});
  EXPECT_EQ(second.sign(), -1);
}

}  // namespace
}  // namespace meshalyzer
