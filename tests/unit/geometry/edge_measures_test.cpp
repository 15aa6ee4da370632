#include "meshalyzer/geometry/edge_measures.h"

#include "meshalyzer/geometry/face_measures.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/complex_edges.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<double> angles(const Soup& soup) {
  const CutMesh cut = build(soup);
  return sorted(measure_edge_angles(cut.mesh, measure_faces(cut.mesh).zero_area).degrees);
}

std::vector<double> lengths(const Soup& soup) {
  const CutMesh cut = build(soup);
  return sorted(lengths_of(complex_edges(cut), mesh_edge_lengths(cut.mesh)));
}

/// The angle at the one edge of two faces, from (0, 0, 0) to (1, 0, 0).
/// @param c  The first face's third corner.
/// @param d  The second face's.
double angle_at_hinge(const Vec3& c, const Vec3& d) {
  const std::vector<double> all =
      angles(shapes::make({{0, 0, 0}, {1, 0, 0}, c, d}, {{0, 1, 2}, {1, 0, 3}}));
  EXPECT_EQ(all.size(), 1U);
  return all.front();
}

void expect_all_near(const std::vector<double>& values, std::size_t n, double expected) {
  EXPECT_EQ(values.size(), n);
  for (const double value : values) EXPECT_NEAR(value, expected, 1e-12 * expected);
}

TEST(EdgeLengths, CubeHasTwelveEdgesAndSixDiagonals) {
  const std::vector<double> all = lengths(shapes::cube(3.0));
  ASSERT_EQ(all.size(), 18U);
  expect_all_near({all.begin(), all.begin() + 12}, 12, 3.0);
  expect_all_near({all.begin() + 12, all.end()}, 6, 3.0 * std::numbers::sqrt2);
}

TEST(EdgeLengths, NoSizeOverflowsOrUnderflows) {
  for (const double unit : {1e-310, 1e-200, 1e200, 1e307}) {
    // Sides 3, 4 and 5 units long.
    const std::vector<double> all =
        lengths(shapes::make({{0, 0, 0}, {3 * unit, 0, 0}, {0, 4 * unit, 0}}, {{0, 1, 2}}));
    ASSERT_EQ(all.size(), 3U);
    EXPECT_NEAR(all[2] / unit, 5.0, 1e-12);
  }
}

TEST(EdgeLengths, NonManifoldEdgeCountsOnce) {
  EXPECT_EQ(lengths(shapes::fan_of_three()).size(), 7U);
}

TEST(EdgeAngleDegrees, BothHalfedgesOfAnEdgeAgree) {
  const CutMesh cut = build(shapes::torus(2, 0.5, 12, 8));
  for (const HalfedgeHandle h : cut.mesh.halfedges()) {
    EXPECT_NEAR(edge_angle_degrees(cut.mesh, h),
                edge_angle_degrees(cut.mesh, cut.mesh.opposite_halfedge_handle(h)), 1e-10);
  }
}

TEST(MeasureEdgeAngles, OutwardCubeIsConvexAtEdgesAndFlatAtDiagonals) {
  const std::vector<double> all = angles(shapes::cube());
  ASSERT_EQ(all.size(), 18U);
  EXPECT_EQ(std::count(all.begin(), all.end(), 180.0), 6);
  expect_all_near({all.begin() + 6, all.end()}, 12, 270.0);
}

TEST(MeasureEdgeAngles, InwardCubeIsConcaveAtEdges) {
  const std::vector<double> all = angles(shapes::flipped(shapes::cube()));
  ASSERT_EQ(all.size(), 18U);
  EXPECT_EQ(std::count(all.begin(), all.end(), 180.0), 6);
  expect_all_near({all.begin(), all.begin() + 12}, 12, 90.0);
}

TEST(MeasureEdgeAngles, RegularTetrahedronHasItsDihedralAngleOutside) {
  const Soup soup = shapes::make({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                 {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
  expect_all_near(angles(soup), 6, 360.0 - std::acos(1.0 / 3.0) * 180.0 / std::numbers::pi);
}

TEST(MeasureEdgeAngles, FlatGridIsFlatExactly) {
  // 3 nx ny + nx + ny edges less the 2 (nx + ny) of the border.
  EXPECT_EQ(angles(shapes::grid(4, 3)), std::vector<double>(36 - 7, 180.0));
}

TEST(MeasureEdgeAngles, FacesInOnePlaneAreFlatOrFoldedExactly) {
  EXPECT_EQ(angle_at_hinge({0.3, 1, 0}, {0.6, -0.7, 0}), 180.0);
  EXPECT_EQ(angle_at_hinge({0.3, 1, 0}, {0.6, 0.7, 0}), 0.0);
  EXPECT_EQ(angle_at_hinge({0.5, 0.1, 0.1}, {-7, -0.3, -0.3}), 180.0);
  EXPECT_EQ(angle_at_hinge({0.5, 0.1, 0.1}, {-7, 0.3, 0.3}), 0.0);
}

TEST(MeasureEdgeAngles, QuarterTurnUpIsAWallAndDownIsACubesEdge) {
  EXPECT_NEAR(angle_at_hinge({0.5, 1, 0}, {0.5, 0, 1}), 90.0, 1e-12);
  EXPECT_NEAR(angle_at_hinge({0.5, 1, 0}, {0.5, 0, -1}), 270.0, 1e-12);
}

TEST(MeasureEdgeAngles, AnyAngleIsMeasuredFromTheFirstNormalsSide) {
  for (int degrees = 1; degrees < 360; ++degrees) {
    const double radians = degrees * std::numbers::pi / 180.0;
    const Vec3 d(0.4, std::cos(radians), std::sin(radians));
    EXPECT_NEAR(angle_at_hinge({0.5, 1, 0}, d), degrees, 1e-11);
  }
}

TEST(MeasureEdgeAngles, FoldByOneBitIsOnItsRightSide) {
  // The first face lies in the plane z = y and its normal is (0, -1, 1).
  const double above = angle_at_hinge({0.5, 1, 1}, {0.25, 1, std::nextafter(1.0, 2.0)});
  const double below = angle_at_hinge({0.5, 1, 1}, {0.25, 1, std::nextafter(1.0, 0.0)});
  EXPECT_GE(above, 0.0);
  EXPECT_LT(above, 1e-10);
  EXPECT_LE(below, 360.0);
  EXPECT_GT(below, 360.0 - 1e-10);
}

TEST(MeasureEdgeAngles, FoldBySmallestNumberIsOnItsRightSide) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double above = angle_at_hinge({0.5, 1, 0}, {0.25, 1, tiny});
  const double below = angle_at_hinge({0.5, 1, 0}, {0.25, 1, -tiny});
  EXPECT_GE(above, 0.0);
  EXPECT_LT(above, 1e-10);
  EXPECT_LE(below, 360.0);
  EXPECT_GT(below, 360.0 - 1e-10);
}

TEST(MeasureEdgeAngles, SliverHasTheAngleOfItsPlane) {
  // The second face stands upright on the first, its height one part in 10^18 of its base.
  EXPECT_NEAR(angle_at_hinge({0.5, 1, 0}, {0.5, 0, 1e-18}), 90.0, 1e-9);
  EXPECT_NEAR(angle_at_hinge({0.5, 1e-18, 0}, {0.5, 0, -1e-18}), 270.0, 1e-9);
}

TEST(MeasureEdgeAngles, BordersFlippedAndNonManifoldEdgesHaveNone) {
  EXPECT_TRUE(angles(shapes::fan_of_three()).empty());
  const std::vector<Index> turned{0};
  // A cube's face turned over loses the angles at its three edges.
  EXPECT_EQ(angles(shapes::flipped(shapes::cube(), turned)).size(), 15U);
}

TEST(MeasureEdgeAngles, EdgesOfZeroAreaFacesHaveNone) {
  // The second face is flat; the first and the third share an edge of their own.
  const Soup soup = shapes::make({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}},
                                 {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}});
  EXPECT_EQ(angles(soup), std::vector<double>{180.0});
}

TEST(MeasureEdgeAngles, PowersOfTwoKeepAnglesToTheLastDigit) {
  const Soup soup = shapes::torus(2, 0.5, 12, 8);
  const std::vector<double> before = angles(soup);
  for (const int exponent : {-900, -500, -400, 400, 500, 1000}) {
    SCOPED_TRACE(exponent);
    EXPECT_EQ(angles(shapes::scaled(soup, std::ldexp(1.0, exponent))), before);
  }
}

TEST(MeasureEdgeAngles, CubeOfTheLargestDoublesHasTheAnglesOfACube) {
  const std::vector<double> all =
      angles(shapes::scaled(shapes::cube(2.0, Vec3::Constant(-1.0)), 1.7e308));
  ASSERT_EQ(all.size(), 18U);
  EXPECT_EQ(std::count(all.begin(), all.end(), 180.0), 6);
  expect_all_near({all.begin() + 6, all.end()}, 12, 270.0);
}

TEST(MeasureEdgeAngles, TinyFacesFarFromTheOriginHaveTheAngleOfTheirPlanes) {
  // The first face lies in the plane x = 1e100, and its normal points along x. The second one lies
  // behind it, in the plane z = 0.
  const Soup soup = shapes::make({{1e100, 0, 0}, {1e100, 1e-200, 0}, {1e100, 0, 1e-200}, {0, 0, 0}},
                                 {{0, 1, 2}, {1, 0, 3}});
  const std::vector<double> all = angles(soup);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(all.front(), 270.0, 1e-12);
}

TEST(MeasureEdgeAngles, ScalingAndRigidMotionKeepAngles) {
  const Soup soup = shapes::icosphere(1);
  const std::vector<double> before = angles(soup);
  Soup moved = shapes::scaled(soup, 7.0);
  const Eigen::AngleAxisd turn(0.7, Vec3(1, -2, 3).normalized());
  for (Vec3& p : moved.positions) p = turn * p + Vec3(5, 6, -7);
  const std::vector<double> after = angles(moved);
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-10);
}

}  // namespace
}  // namespace meshalyzer
