#include "meshalyzer/contour/contour_mesh.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "meshalyzer/spatial/triangle_distance.h"
#include "support/no_lengths.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace meshalyzer {
namespace {

double volume_of(const Soup& soup) {
  double sum = 0;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const auto [a, b, c] = corners_of(soup, f);
    sum += a.dot(b.cross(c));
  }
  return sum / 6;
}

void expect_embedded_solid(const Soup& soup) {
  const CutMesh cut = build(soup);
  EXPECT_EQ(cut.side.non_manifold_edges.size(), 0U);
  EXPECT_EQ(cut.side.flipped_edges.size(), 0U);
  EXPECT_TRUE(cut.side.non_manifold_vertices.empty());
  for (const auto h : cut.mesh.halfedges()) ASSERT_FALSE(cut.mesh.is_boundary(h));
  EXPECT_TRUE(find_self_intersections(cut, FaceTree(cut)).empty());
}

/// The contour of a mesh, which must be good and within the deviation.
Soup contour_within(const Soup& soup, double max_deviation) {
  const auto made = contour_mesh(soup, {.max_deviation = max_deviation});
  if (!made) {
    ADD_FAILURE() << "no contour";
    return {};
  }
  EXPECT_TRUE(made->is_within) << made->deviation;
  EXPECT_LE(made->deviation, max_deviation);
  EXPECT_FALSE(made->soup.triangles.empty());
  expect_embedded_solid(made->soup);
  return made->soup;
}

TEST(ContourMesh, OfASphereHasItsVolume) {
  const Soup sphere = shapes::icosphere(2);
  EXPECT_NEAR(volume_of(contour_within(sphere, 0.03)), volume_of(sphere), 0.05);
}

TEST(ContourMesh, EdgesInsideAreNotApproximatedWhereFacesTouchAlmost) {
  // A block stands in a notch that two others leave, so closely that no grid shows the gap: where
  // they cover its edge, the edge lies inside the solid. It crosses neither.
  constexpr double kGap = 1e-9;
  // No plane of the grid runs through the gap.
  constexpr double kSide = 0.9987;
  const Soup block = shapes::box({0, 0, 0}, {kSide, 1, kSide});
  const Soup above = shapes::box({0.5, 0.25, kSide + kGap}, {1.5, 0.75, 1.5});
  const Soup beside = shapes::box({kSide + kGap, 0.25, 0.5}, {1.5, 0.75, 1.25});
  const Soup soup = shapes::merged(shapes::merged(block, above), beside);
  // Volumes of about 1 + 1/4 + 1/8.
  EXPECT_NEAR(volume_of(contour_within(soup, 0.01)), 1.375, 0.05);
}

TEST(ContourMesh, OfCubesThatCrossIsTheirUnion) {
  // Volumes 8 + 8 - 1.
  const Soup cubes = shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1}));
  EXPECT_NEAR(volume_of(contour_within(cubes, 0.02)), 15, 0.3);
}

/// The largest distance of a vertex or a centroid of a contour from a surface, by comparison with
/// each face of that.
double largest_distance(const Soup& contour, const Soup& surface) {
  double largest = 0;
  const auto note = [&](const Vec3& point) {
    double distance = std::numeric_limits<double>::infinity();
    for (Index f = 0; f < surface.n_faces(); ++f) {
      distance = std::min(distance, closest_on_triangle(corners_of(surface, f), point).distance);
    }
    largest = std::max(largest, distance);
  };
  for (const Vec3& p : contour.positions) note(p);
  for (Index f = 0; f < contour.n_faces(); ++f) note(centroid_of(corners_of(contour, f)));
  return largest;
}

TEST(ContourMesh, TellsTheLargestDistanceOfItsPoints) {
  const Soup sphere = shapes::icosphere(1);
  for (const double limit : {0.05, 0.02}) {
    const auto made = contour_mesh(sphere, {.max_deviation = limit});
    ASSERT_TRUE(made && made->is_within);
    EXPECT_GE(made->deviation, largest_distance(made->soup, sphere));
  }
  const auto coarse = contour_mesh(sphere, {.max_deviation = 0.001, .max_tetrahedra = 10'000});
  ASSERT_TRUE(coarse && !coarse->is_within);
  EXPECT_GE(coarse->deviation, largest_distance(coarse->soup, sphere));
}

TEST(ContourMesh, KeepsACavity) {
  EXPECT_NEAR(volume_of(contour_within(shapes::nested_cubes(shapes::InnerShell::Cavity), 0.02)), 26,
              0.5);
}

TEST(ContourMesh, DropsAWallInsideASolid) {
  EXPECT_NEAR(volume_of(contour_within(shapes::nested_cubes(shapes::InnerShell::Outward), 0.02)),
              27, 0.5);
}

TEST(ContourMesh, ClosesASolidWithALidMissing) {
  EXPECT_GT(volume_of(contour_within(shapes::open_cube(), 0.02)), 0.7);
}

TEST(ContourMesh, TakesAMeshThatPointsInwards) {
  Soup cube = shapes::cube();
  for (Triangle& t : cube.triangles) std::swap(t[1], t[2]);
  EXPECT_NEAR(volume_of(contour_within(cube, 0.01)), 1, 0.05);
}

TEST(ContourMesh, FindsAPlateThatIsThinnerThanTheFirstCells) {
  Soup plate = shapes::cube(4);
  for (Vec3& p : plate.positions) p.z() *= 0.01;
  EXPECT_NEAR(volume_of(contour_within(plate, 0.01)), 4 * 4 * 0.04, 0.1);
}

TEST(ContourMesh, OfWhatLiesInABoxIsNearTheSurfaceThereAndClosedBeyond) {
  // The sphere of radius 1 in a box round its pole.
  const Soup sphere = shapes::icosphere(4);
  const Box3 box(Vec3(-0.25, -0.25, 0.75), Vec3(0.25, 0.25, 1.25));
  const auto made = contour_mesh(sphere, {.max_deviation = 0.01, .within = box});
  ASSERT_TRUE(made && made->is_within);
  expect_embedded_solid(made->soup);
  std::size_t n_in_box = 0;
  for (const Vec3& p : made->soup.positions) {
    EXPECT_LE(p.norm(), 1.01);
    EXPECT_GT(p.z(), 0.5);
    if (!box.contains(p)) continue;
    ++n_in_box;
    // The flat faces lie within 0.002 of the sphere.
    EXPECT_NEAR(p.norm(), 1.0, 0.0125);
  }
  EXPECT_GT(n_in_box, 50U);
  EXPECT_LT(made->soup.n_faces(), contour_within(sphere, 0.01).n_faces() / 4);
}

TEST(ContourMesh, SaysWhereTheGridWouldBeTooLarge) {
  const auto made =
      contour_mesh(shapes::icosphere(1), {.max_deviation = 1e-9, .max_tetrahedra = 10'000});
  ASSERT_TRUE(made);
  EXPECT_FALSE(made->is_within);
  EXPECT_GT(made->deviation, 1e-9);
  // It ends at the limit, and does not refine the grid at all far points first.
  EXPECT_GT(made->n_tetrahedra, 10'000U);
  EXPECT_LT(made->n_tetrahedra, 20'000U);
  expect_embedded_solid(made->soup);
}

TEST(ContourMesh, OfNothingIsNone) {
  EXPECT_FALSE(contour_mesh(Soup(), {.max_deviation = 1}));
  EXPECT_THROW((void)contour_mesh(shapes::cube(), {.max_deviation = 0}), InvalidArgument);
}

TEST(ContourMesh, DeviationThatIsNotPositiveAndFiniteIsRefused) {
  for (const double no_length : test::kNoLengths) {
    EXPECT_THROW(static_cast<void>(contour_mesh(shapes::cube(), {.max_deviation = no_length})),
                 InvalidArgument)
        << no_length;
  }
}

// A face whose area is no double, the difference of products that overflow, was halved until the
// stack was full.
TEST(ContourMesh, FaceAsLargeAsDoublesAreIsNotDividedForASmallBox) {
  const Soup soup = shapes::merged(
      shapes::cube(0.5),
      shapes::make({{-1e308, 0.25, -1e200}, {1e154, 3, 1}, {0, -1e308, 0}}, {{0, 1, 2}}));
  const Box3 box(Vec3(-0.25, -0.25, -0.25), Vec3(1, 1, 1));
  const auto contour =
      contour_mesh(soup, {.max_deviation = 0.1, .max_tetrahedra = 4000, .within = box});
  ASSERT_TRUE(contour);
  expect_embedded_solid(contour->soup);
}

}  // namespace
}  // namespace meshalyzer
