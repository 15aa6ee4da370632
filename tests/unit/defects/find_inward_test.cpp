#include "meshalyzer/defects/finders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace meshalyzer {
namespace {

using shapes::InnerShell;

DefectList inward_in(const Soup& soup) {
  return find_inward(PreparedMesh(soup));
}

/// The lowest face of each defect.
std::vector<Index> named_by(const DefectList& defects) {
  std::vector<Index> faces;
  for (const Defect& defect : defects) {
    EXPECT_EQ(defect.code, DefectCode::Inward);
    EXPECT_EQ(defect.faces.size(), 1U);
    EXPECT_EQ(defect.positions.size(), 1U);
    faces.push_back(defect.faces.at(0));
  }
  return faces;
}

using Faces = std::vector<Index>;

TEST(FindInward, OutwardMeshesHaveNone) {
  for (const Soup& soup : {Soup{}, shapes::cube(), shapes::torus(2, 1, 8, 8),
                           shapes::nested_cubes(InnerShell::Cavity)}) {
    EXPECT_TRUE(inward_in(soup).empty());
  }
}

TEST(FindInward, CubeInsideOutIsOneWithItsVolume) {
  const DefectList defects = inward_in(shapes::flipped(shapes::cube(2.0)));
  EXPECT_EQ(named_by(defects), Faces{0});
  EXPECT_NEAR(defects.at(0).value.value(), -8.0, 1e-12);
}

TEST(FindInward, OutwardShellInAnotherIsInwardSinceCavitiesPointIn) {
  const DefectList defects = inward_in(shapes::nested_cubes(InnerShell::Outward));
  EXPECT_EQ(named_by(defects), Faces{12});
  EXPECT_NEAR(defects.at(0).value.value(), 1.0, 1e-12);
}

TEST(FindInward, ShellsAlternateHoweverDeeplyTheyLie) {
  // Sides 7, 5, 3, 1, all outward: the second and the fourth are wrong; all turned, the others.
  Soup soup;
  for (int depth = 0; depth < 4; ++depth) {
    soup = shapes::merged(soup, shapes::cube(7.0 - 2 * depth, Vec3::Constant(depth)));
  }
  EXPECT_EQ(named_by(inward_in(soup)), (Faces{12, 36}));
  EXPECT_EQ(named_by(inward_in(shapes::flipped(soup))), (Faces{0, 24}));
}

TEST(FindInward, CrossingCubesAreNotInEachOther) {
  const Soup other = shapes::cube(1.0, {0.5, 0.25, 0.125});
  EXPECT_TRUE(inward_in(shapes::merged(shapes::cube(), other)).empty());
  EXPECT_EQ(named_by(inward_in(shapes::merged(shapes::cube(), shapes::flipped(other)))), Faces{12});
}

TEST(FindInward, CubeThatReachesOutOfAnotherByACornerIsNotInIt) {
  Soup spike = shapes::merged(shapes::cube(4.0, Vec3::Constant(-2.0)), shapes::cube());
  spike.positions[8] = Vec3::Constant(-2.001);
  EXPECT_TRUE(inward_in(spike).empty());
}

TEST(FindInward, OnlyClosedManifoldConsistentComponentsHaveAnAnswer) {
  for (const Soup& soup :
       {shapes::flipped(shapes::open_cube()), shapes::flipped(shapes::grid(2, 2)),
        shapes::flipped(shapes::two_tetrahedra_sharing_vertex()),
        shapes::flipped(shapes::two_tetrahedra_sharing_edge()),
        shapes::flipped(shapes::flipped(shapes::cube()), std::array{Index{3}}),
        shapes::klein_bottle(6, 6), shapes::flipped(shapes::pillow())}) {
    EXPECT_TRUE(inward_in(soup).empty());
  }
}

TEST(FindInward, OpenShellEnclosesNothingAndHidesNothing) {
  const Soup box =
      shapes::translated(shapes::scaled(shapes::open_cube(), 3.0), Vec3::Constant(-1.0));
  EXPECT_TRUE(inward_in(shapes::merged(box, shapes::cube())).empty());
  EXPECT_EQ(named_by(inward_in(shapes::merged(box, shapes::flipped(shapes::cube())))), Faces{10});
}

TEST(FindInward, ShellOneBitThickIsDecided) {
  Soup soup = shapes::tetrahedron();
  for (Vec3& p : soup.positions) p.z() = 0.1;
  soup.positions[3] = {0.25, 0.25, std::nextafter(0.1, 0.0)};
  EXPECT_EQ(named_by(inward_in(soup)), Faces{0});
  soup.positions[3].z() = std::nextafter(0.1, 1.0);
  EXPECT_TRUE(inward_in(soup).empty());
}

TEST(FindInward, VolumeTooLargeForADoubleHasNoValue) {
  const DefectList defects = inward_in(shapes::flipped(shapes::cube(1e300)));
  EXPECT_EQ(named_by(defects), Faces{0});
  EXPECT_FALSE(defects.at(0).value.has_value());
}

}  // namespace
}  // namespace meshalyzer
