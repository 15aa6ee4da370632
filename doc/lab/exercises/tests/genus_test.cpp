#include "genus.h"

#include "shapes.h"

#include <gtest/gtest.h>

namespace lab {
namespace {

TEST(GenusOfClosedShell, OfTheCubeIsZero) {
  EXPECT_EQ(genus_of_closed_shell(8, 18, 12), 0);
}

TEST(GenusOfClosedShell, OfASevenVertexTorusIsOne) {
  // Császár's polyhedron: every two of its vertices are joined.
  EXPECT_EQ(genus_of_closed_shell(7, 21, 14), 1);
}

TEST(GenusOfClosedShell, HalfAHandleIsNone) {
  EXPECT_EQ(genus_of_closed_shell(7, 18, 12).has_value(), false);
  EXPECT_EQ(genus_of_closed_shell(2903, 8706, 5804).has_value(), false);
}

TEST(GenusOfClosedShell, LessThanNoHandleIsNone) {
  // Two cubes counted as one shell.
  EXPECT_EQ(genus_of_closed_shell(16, 36, 24).has_value(), false);
}

TEST(EulerNumber, OfClosedShells) {
  EXPECT_EQ(euler_number(shapes::cube()), 2);
  EXPECT_EQ(euler_number(shapes::torus(5)), 0);
}

TEST(EulerNumber, DoesNotCountOrphans) {
  EXPECT_EQ(euler_number(shapes::with_orphan(shapes::cube())), 2);
}

TEST(EulerNumber, OfADiscIsOneAndOfARingZero) {
  EXPECT_EQ(euler_number(shapes::square()), 1);
  EXPECT_EQ(euler_number(shapes::annulus(6)), 0);
}

TEST(NumberOfBoundaries, CountsLoopsNotEdges) {
  EXPECT_EQ(n_boundaries(shapes::cube()), 0);
  EXPECT_EQ(n_boundaries(shapes::square()), 1);
  EXPECT_EQ(n_boundaries(shapes::annulus(6)), 2);
}

TEST(NumberOfComponents, OrphanIsNone) {
  EXPECT_EQ(n_components(shapes::with_orphan(shapes::cube())), 1);
}

TEST(NumberOfComponents, OfTwoShellsIsTwo) {
  EXPECT_EQ(n_components(shapes::together(shapes::cube(), shapes::torus(5))), 2);
}

TEST(Genus, OfSphereAndTorus) {
  EXPECT_EQ(genus(shapes::octahedron()), 0);
  EXPECT_EQ(genus(shapes::torus(5)), 1);
}

TEST(Genus, AHoleIsNoHandle) {
  EXPECT_EQ(genus(shapes::open_octahedron()), 0);
  EXPECT_EQ(genus(shapes::annulus(6)), 0);
}

TEST(Genus, OfSeveralComponentsIsTheSum) {
  const TriMesh tori = shapes::together(shapes::torus(5), shapes::torus(6));
  EXPECT_EQ(genus(tori), 2);
  EXPECT_EQ(genus(shapes::together(tori, shapes::square())), 2);
}

TEST(Genus, OrphanChangesNothing) {
  EXPECT_EQ(genus(shapes::with_orphan(shapes::torus(5))), 1);
}

}  // namespace
}  // namespace lab
