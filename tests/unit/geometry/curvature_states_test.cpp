#include "curvature_of.h"
#include "meshalyzer/geometry/curvature.h"
#include "meshalyzer/geometry/vertex_normals.h"
#include "meshalyzer/mesh/build.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace meshalyzer {
namespace {

using enum CurvatureState;

/// Expects that the columns are filled as the states say.
void expect_figures_where_defined(const Curvature& c) {
  for (std::size_t v = 0; v < c.state.size(); ++v) {
    const bool is_defined = c.state[v] == Defined;
    for (const auto* column : {&c.gaussian, &c.mean, &c.k1, &c.k2}) {
      EXPECT_EQ(std::isfinite((*column)[v]), is_defined);
      if (!is_defined) {
        EXPECT_TRUE(std::isnan((*column)[v]));
      }
    }
    EXPECT_TRUE(std::isfinite(c.angle_defect[v]));
    if (is_defined) {
      EXPECT_GE(c.k1[v], c.k2[v]);
    }
    if (!is_defined) {
      EXPECT_EQ(c.direction1[v], Vec3::Zero());
    }
    const bool has_directions = !c.direction1[v].isZero(0.0);
    EXPECT_NEAR(c.direction1[v].norm(), has_directions ? 1.0 : 0.0, 1e-12);
    EXPECT_NEAR(c.direction2[v].norm(), has_directions ? 1.0 : 0.0, 1e-12);
    EXPECT_NEAR(c.direction1[v].dot(c.direction2[v]), 0.0, 1e-12);
  }
}

TEST(CurvatureStates, OrphanIsUnused) {
  Soup soup = shapes::cube();
  soup.positions.emplace_back(1e300, 0, 0);
  const Curvature c = curvature_of(soup);
  ASSERT_EQ(c.state.size(), 9U);
  EXPECT_EQ(c.state[8], Unused);
  EXPECT_TRUE(std::isnan(c.area[8]));
  EXPECT_NEAR(c.angle_defect[8], 2 * std::numbers::pi, 1e-15);
  EXPECT_EQ(std::count(c.state.begin(), c.state.end(), Defined), 8);
  EXPECT_NEAR(c.mean[0], 2 / std::numbers::sqrt3, 1e-14);
  expect_figures_where_defined(c);
}

TEST(CurvatureStates, BorderIsSaidAndItsAreaGiven) {
  const Soup plane = shapes::grid(3, 3);
  const Curvature c = curvature_of(plane, VertexArea::Barycentric);
  for (std::size_t v = 0; v < plane.n_vertices(); ++v) {
    const Vec3& p = plane.positions[v];
    const bool inside = p.x() > 0 && p.x() < 3 && p.y() > 0 && p.y() < 3;
    EXPECT_EQ(c.state[v], inside ? Defined : Border);
    EXPECT_GE(c.area[v], 1.0 / 6);
    // The sums of the angles and of the sides round a flat vertex are off by rounding alone.
    if (inside) {
      EXPECT_NEAR(c.gaussian[v], 0.0, 1e-14);
      EXPECT_EQ(c.mean[v], 0.0);
      EXPECT_EQ(c.k1[v], 0.0);
      EXPECT_EQ(c.direction1[v], Vec3::Zero());
    }
  }
  expect_figures_where_defined(c);
}

TEST(CurvatureStates, PinchedVertexIsNotOneFan) {
  const Curvature c = curvature_of(shapes::two_tetrahedra_sharing_vertex(), VertexArea::OneRing);
  EXPECT_EQ(std::count(c.state.begin(), c.state.end(), NotOneFan), 1);
  EXPECT_EQ(c.state[0], NotOneFan);
  // Six right angles; six faces of area 1/2.
  EXPECT_NEAR(c.angle_defect[0], -std::numbers::pi, 1e-14);
  EXPECT_NEAR(c.area[0], 3.0, 1e-14);
  expect_figures_where_defined(c);
}

TEST(CurvatureStates, EndsOfANonManifoldEdgeAreNotOneFan) {
  const Curvature c = curvature_of(shapes::two_tetrahedra_sharing_edge());
  for (std::size_t v = 0; v < 6; ++v) {
    EXPECT_EQ(c.state[v], v == 0 || v == 3 ? NotOneFan : Defined);
  }
  expect_figures_where_defined(c);
}

TEST(CurvatureStates, EndsOfAFlippedEdgeAreNotOneFan) {
  const Soup cube = shapes::cube();
  const Index turned = 4;
  const Curvature c = curvature_of(shapes::flipped(cube, {&turned, 1}));
  const Triangle& t = cube.triangles[turned];
  for (Index v = 0; v < 8; ++v) {
    EXPECT_EQ(c.state[v], std::count(t.begin(), t.end(), v) > 0 ? NotOneFan : Defined);
    // Turning a face over changes no angle.
    EXPECT_NEAR(c.angle_defect[v], std::numbers::pi / 2, 1e-14);
  }
  expect_figures_where_defined(c);
}

/// Six faces over and six under a flat star with points at 0.1 and 1 in turn: at the poles all
/// faces have an obtuse angle at the near point, and a circumcentre on its far side.
Soup star() {
  Soup soup = shapes::make({{0, 0, 0.01}, {0, 0, -0.01}}, {});
  for (Index i = 0; i < 6; ++i) {
    const double radius = i % 2 == 0 ? 0.1 : 1.0;
    const double angle = i * std::numbers::pi / 3;
    soup.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    const Index next = 2 + (i + 1) % 6;
    soup.triangles.push_back({0, 2 + i, next});
    soup.triangles.push_back({1, next, 2 + i});
  }
  return soup;
}

TEST(CurvatureStates, NegativeAreaIsNone) {
  const Curvature voronoi = curvature_of(star(), VertexArea::Voronoi);
  EXPECT_EQ(voronoi.state[0], NoArea);
  EXPECT_LT(voronoi.area[0], 0.0);
  expect_figures_where_defined(voronoi);
  const Curvature mixed = curvature_of(star(), VertexArea::Mixed);
  EXPECT_EQ(mixed.state[0], Defined);
  EXPECT_GT(mixed.area[0], 0.0);
}

TEST(CurvatureStates, FacesWithoutAreaCountForNothing) {
  // The cube with vertex 8 in the middle of an edge, joined by two faces of zero area.
  Soup cube = shapes::cube();
  const Curvature before = curvature_of(cube);
  const Triangle t = cube.triangles[0];
  cube.positions.push_back((cube.positions[t[0]] + cube.positions[t[1]]) / 2);
  cube.triangles[0] = {8, t[1], t[2]};
  cube.triangles.push_back({t[0], 8, t[2]});
  cube.triangles.push_back({t[1], 8, t[0]});
  const Curvature c = curvature_of(cube);
  ASSERT_EQ(std::count(c.state.begin(), c.state.end(), Defined), 9);
  EXPECT_NEAR(c.angle_defect[8], 0.0, 1e-14);
  // Its two faces with an area lie in one plane.
  EXPECT_NEAR(c.gaussian[8], 0.0, 1e-13);
  const Index far = 7 - t[0];
  EXPECT_NEAR(c.angle_defect[t[0]], std::numbers::pi / 2, 1e-14);
  EXPECT_EQ(before.state[far], c.state[far]);
  expect_figures_where_defined(c);
}

TEST(CurvatureStates, SideTooShortToBeSquaredDoesNoHarm) {
  // Two neighbours of the icosahedron 1e-170 from each other, at the origin.
  Soup ball = shapes::icosphere(0);
  const Triangle t = ball.triangles[0];
  ball = shapes::translated(ball, -ball.positions[t[0]]);
  ball.positions[t[1]] = Vec3(1e-170, 0, 0);
  const CutMesh cut = build(ball);
  const Curvature c = measure_curvature(cut);
  expect_figures_where_defined(c);
  const std::vector<Vec3> normals = vertex_normals(cut);
  for (const Index v : {t[0], t[1]}) {
    ASSERT_EQ(c.state[v], Defined);
    EXPECT_GT(c.mean[v], 0.0);
    EXPECT_GT(c.direction1[v].norm(), 0.5);
    EXPECT_NEAR(c.direction1[v].dot(normals[v]), 0.0, 1e-12);
    EXPECT_NEAR(c.direction2[v].dot(normals[v]), 0.0, 1e-12);
  }
}

TEST(CurvatureStates, VertexAmongZeroAreaFacesAloneHasNoArea) {
  Soup line = shapes::icosphere(0);
  for (Vec3& p : line.positions) p = Vec3(p.x(), 0, 0);
  for (const CurvatureState state : curvature_of(line).state) EXPECT_EQ(state, NoArea);
}

TEST(CurvatureStates, FacesBackToBackHaveNoSide) {
  for (const CurvatureState state : curvature_of(shapes::pillow()).state) {
    EXPECT_EQ(state, NoArea);
  }
}

/// A square of 3 x 3 without two corners, and its back, sewn together along the border; the back's
/// inner vertices are behind those of the square.
Soup double_sheet() {
  // Faces of border vertices alone, which the front and the back would have in common.
  const Soup front = shapes::without_faces(shapes::grid(3, 3), std::vector<Index>{4, 13});
  Soup sheet = front;
  std::vector<Index> behind(front.n_vertices());
  for (Index v = 0; v < behind.size(); ++v) {
    const bool is_rim = v % 4 % 3 == 0 || v / 4 % 3 == 0;
    behind[v] = is_rim ? v : static_cast<Index>(sheet.n_vertices());
    if (!is_rim) sheet.positions.push_back(front.positions[v]);
  }
  for (const Triangle& t : front.triangles) {
    sheet.triangles.push_back({behind[t[0]], behind[t[2]], behind[t[1]]});
  }
  return sheet;
}

TEST(CurvatureStates, DoubleSheetIsFlatAndItsRimHasNoSide) {
  // Slanted, so that the normals at the rim cancel but for rounding.
  Soup sheet = double_sheet();
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (Vec3& p : sheet.positions) p = turn * p;
  const Curvature c = curvature_of(sheet);
  for (std::size_t v = 0; v < sheet.n_vertices(); ++v) {
    const bool is_rim = v < 16 && (v % 4 % 3 == 0 || v / 4 % 3 == 0);
    const bool is_cut_off = v == 3 || v == 12;
    EXPECT_EQ(c.state[v], is_cut_off ? Unused : is_rim ? NoArea : Defined) << v;
    if (is_rim) continue;
    // Their faces at the rim have no normal to turn towards, and a flat sheet no directions.
    EXPECT_NEAR(c.k1[v], 0.0, 1e-14);
    EXPECT_NEAR(c.k2[v], 0.0, 1e-14);
    EXPECT_EQ(c.direction1[v], Vec3::Zero());
  }
  expect_figures_where_defined(c);
}

TEST(CurvatureStates, FoldInAPlaneIsFlat) {
  // Four faces round vertex 0, of which the second goes back by 20 degrees and so lies face down.
  Soup fan = shapes::make({{0, 0, 0}}, {});
  for (const double degrees : {0.0, 120.0, 100.0, 240.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    fan.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  fan.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  const Curvature c = curvature_of(fan);
  ASSERT_EQ(c.state[0], Defined);
  // Angles of 120 + 20 + 140 + 120 degrees.
  EXPECT_NEAR(c.angle_defect[0], -40 * std::numbers::pi / 180, 1e-14);
  EXPECT_EQ(c.k1[0], 0.0);
  EXPECT_EQ(c.k2[0], 0.0);
  expect_figures_where_defined(c);
}

TEST(CurvatureStates, AnyDamageLeavesFiguresOrSaysWhyNot) {
  std::mt19937 random(11);
  for (const Index rarity : {2U, 4U, 10U, 50U}) {
    const Soup torus = shapes::torus(2, 0.7, 12, 9);
    Soup soup = damaged(torus, rarity, random);
    // Points that coincide, and others far away or next to the middle.
    for (int i = 0; i < 9; ++i) {
      soup.positions[below(random, 108)] = soup.positions[below(random, 108)];
      for (const double factor : {1e160, 1e-160, 1e306, 1e-310}) {
        const Index v = below(random, 108);
        soup.positions[v] = torus.positions[v] * factor;
      }
    }
    for (const VertexArea area : {VertexArea::Mixed, VertexArea::Voronoi, VertexArea::OneRing}) {
      expect_figures_where_defined(curvature_of(soup, area));
    }
  }
}

}  // namespace
}  // namespace meshalyzer
