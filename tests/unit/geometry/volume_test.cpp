#include "meshalyzer/geometry/volume.h"

#include "meshalyzer/mesh/build.h"
#include "support/rational_oracle.h"
#include "support/shape_figures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

/// Boxes and volumes of the parts of a mesh.
struct Extents {
  std::vector<Box3> boxes;
  std::vector<SignedVolume> volumes;
};

Extents extents(const Soup& soup, const std::vector<Index>& part_of_face, std::size_t n_parts) {
  const CutMesh cut = build(soup);
  const FaceParts parts{.of_face = part_of_face, .count = n_parts};
  Extents result;
  result.boxes = bounding_boxes(cut.mesh, parts);
  result.volumes = signed_volumes(cut.mesh, parts, result.boxes);
  return result;
}

SignedVolume volume(const Soup& soup) {
  return extents(soup, std::vector<Index>(soup.n_faces(), 0), 1).volumes.front();
}

/// A tetrahedron of any four points; its volume has the sign of their orientation.
Soup tetrahedron_of(const std::array<Vec3, 4>& p) {
  return shapes::make({p.begin(), p.end()}, shapes::tetrahedron().triangles);
}

TEST(BoundingBoxes, HoldTheVerticesThatFacesUse) {
  Soup soup = shapes::cube(2.0, {-1, 5, 0.5});
  soup.positions.emplace_back(100, 100, 100);
  const Extents whole = extents(soup, std::vector<Index>(12, 0), 1);
  EXPECT_EQ(whole.boxes[0].min(), Vec3(-1, 5, 0.5));
  EXPECT_EQ(whole.boxes[0].max(), Vec3(1, 7, 2.5));
}

TEST(BoundingBoxes, PartsHaveTheirOwnAndFacesOfNoneCountNowhere) {
  const Soup soup = shapes::merged(shapes::tetrahedron(), shapes::cube(1.0, {5, 5, 5}));
  std::vector<Index> part_of_face(16, 2);
  for (std::size_t f = 0; f < 4; ++f) part_of_face[f] = kNoIndex;
  const Extents all = extents(soup, part_of_face, 3);
  EXPECT_TRUE(all.boxes[0].isEmpty());
  EXPECT_TRUE(all.boxes[1].isEmpty());
  EXPECT_EQ(all.boxes[2].min(), Vec3(5, 5, 5));
  EXPECT_EQ(all.boxes[2].max(), Vec3(6, 6, 6));
}

TEST(SignedVolumes, ShapesHaveTheVolumeOfTheirFormulas) {
  for (const ShapeFigures& shape : all_shapes()) {
    SCOPED_TRACE(shape.name);
    if (!shape.volume) continue;
    const SignedVolume v = volume(shape.soup);
    EXPECT_NEAR(v.value, *shape.volume, 1e-12 * *shape.volume);
    EXPECT_EQ(v.sign, *shape.volume > 0 ? 1 : 0);
    EXPECT_NEAR(volume(shapes::flipped(shape.soup)).value, -*shape.volume, 1e-12 * *shape.volume);
  }
}

TEST(SignedVolumes, InwardMeshIsNegative) {
  EXPECT_EQ(volume(shapes::flipped(shapes::cube())).sign, -1);
  EXPECT_NEAR(volume(shapes::flipped(shapes::cube())).value, -1.0, 1e-15);
}

TEST(SignedVolumes, EachPartHasItsOwnAndFacesOfNoneCountNowhere) {
  Soup soup = shapes::merged(shapes::nested_cubes(shapes::InnerShell::Cavity), shapes::cube(5.0));
  std::vector<Index> part_of_face(36, kNoIndex);
  for (std::size_t f = 0; f < 12; ++f) part_of_face[f] = 1;
  for (std::size_t f = 12; f < 24; ++f) part_of_face[f] = 0;
  const Extents all = extents(soup, part_of_face, 3);
  EXPECT_NEAR(all.volumes[0].value, -1.0, 1e-14);
  EXPECT_NEAR(all.volumes[1].value, 27.0, 1e-13);
  EXPECT_EQ(all.volumes[0].sign, -1);
  EXPECT_EQ(all.volumes[1].sign, 1);
  EXPECT_EQ(all.volumes[2].value, 0.0);
  EXPECT_EQ(all.volumes[2].sign, 0);
}

TEST(SignedVolumes, MeshFarFromTheOriginKeepsItsDigits) {
  // All coordinates are exact there, so the only rounding is that of the sum.
  for (const double offset : {1e8, 1e15}) {
    const SignedVolume v = volume(shapes::cube(1.0, {offset, -offset, offset}));
    EXPECT_NEAR(v.value, 1.0, 1e-9);
    EXPECT_EQ(v.sign, 1);
  }
}

TEST(SignedVolumes, NearlyFlatTetrahedronHasTheSignOfItsOrientation) {
  // Coplanar but for the last bits, so that the floating-point sum is noise.
  std::mt19937 random(20261121);
  int n_positive = 0;
  for (int round = 0; round < 500; ++round) {
    std::array<Vec3, 4> p;
    for (Vec3& corner : p) {
      const double x = 0.1 * static_cast<double>(random() % 40);
      const double y = 0.1 * static_cast<double>(random() % 40);
      corner = Vec3(x, y, 0.3 * x + 0.7 * y);
    }
    const Sign truth = orient3d(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(volume(tetrahedron_of(p)).sign, truth);
    n_positive += truth > 0 ? 1 : 0;
  }
  EXPECT_GT(n_positive, 100);
}

TEST(SignedVolumes, SliverHasTheVolumeOfItsRationals) {
  // Tilted and thinner than the rounding errors of products of its coordinates.
  std::mt19937 random(20261128);
  std::normal_distribution<double> coordinate;
  for (int round = 0; round < 200; ++round) {
    std::array<Vec3, 4> p;
    for (Vec3& corner : p)
      corner = Vec3(coordinate(random), coordinate(random), coordinate(random));
    p[3] = (p[0] + p[1] + p[2]) / 3 + 1e-15 * p[3];
    const Soup sliver = tetrahedron_of(p);
    std::vector<Vec3> corners;
    for (const Triangle& t : sliver.triangles) {
      for (const Index v : t) corners.push_back(sliver.positions[v]);
    }
    const double truth = test::rational_volume(corners);
    EXPECT_NEAR(volume(sliver).value, truth, 1e-12 * std::abs(truth));
  }
}

TEST(SignedVolumes, WideAndThinHasAVolumeWhoseTermsWouldOverflow) {
  Soup soup = shapes::cube();
  for (Vec3& p : soup.positions) p = p.cwiseProduct(Vec3(1e160, 1e160, 1e-100));
  EXPECT_NEAR(volume(soup).value / 1e220, 1.0, 1e-12);
}

TEST(SignedVolumes, ShellOneBitThickHasASign) {
  const double z = 1e8;
  const std::array<Vec3, 3> base{Vec3(0, 0, z), Vec3(1, 0, z), Vec3(0, 1, z)};
  const auto shell = [&](double apex) {
    return volume(tetrahedron_of({base[0], base[1], base[2], Vec3(0.25, 0.25, apex)}));
  };
  EXPECT_EQ(shell(std::nextafter(z, 2e8)).sign, 1);
  EXPECT_EQ(shell(std::nextafter(z, 0.0)).sign, -1);
  EXPECT_EQ(shell(z).sign, 0);
}

TEST(SignedVolumes, PillowEnclosesNothing) {
  Soup soup = shapes::pillow();
  soup.positions = {{0.1, 0.2, 0.3}, {0.7, 0.1, -0.9}, {1e5, 0.3, 1e-5}};
  EXPECT_EQ(volume(soup).sign, 0);
  EXPECT_NEAR(volume(soup).value, 0.0, 1e-10);
}

TEST(SignedVolumes, AnySizeHasASign) {
  for (const double side : {1e-300, 1e-120, 1e120, 1e300}) {
    EXPECT_EQ(volume(shapes::cube(side)).sign, 1);
    EXPECT_EQ(volume(shapes::flipped(shapes::cube(side))).sign, -1);
  }
}

TEST(SignedVolumes, ScalingMultipliesByTheCube) {
  const Soup soup = shapes::torus(2, 0.5, 12, 8);
  EXPECT_NEAR(volume(shapes::scaled(soup, 3.0)).value, 27 * volume(soup).value, 1e-11);
  EXPECT_NEAR(volume(shapes::scaled(soup, -1.0)).value, -volume(soup).value, 1e-13);
}

TEST(SignedVolumes, RigidMotionKeepsVolume) {
  const Soup soup = shapes::torus(2, 0.5, 12, 8);
  Soup moved = soup;
  const Eigen::AngleAxisd turn(0.7, Vec3(1, -2, 3).normalized());
  for (Vec3& p : moved.positions) p = turn * p + Vec3(5, 6, -7);
  EXPECT_NEAR(volume(moved).value, volume(soup).value, 1e-12);
}

}  // namespace
}  // namespace meshalyzer
