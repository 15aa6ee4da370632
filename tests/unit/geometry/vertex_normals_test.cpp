#include "meshalyzer/geometry/vertex_normals.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace meshalyzer {
namespace {

std::vector<Vec3> normals_of(const Soup& soup, NormalWeight weight = NormalWeight::Angle) {
  return vertex_normals(build(soup), weight);
}

constexpr std::array kWeights{NormalWeight::Uniform, NormalWeight::Area, NormalWeight::Angle};

void expect_near(const Vec3& actual, const Vec3& expected) {
  EXPECT_NEAR((actual - expected).norm(), 0.0, 1e-14)
      << actual.transpose() << " for " << expected.transpose();
}

/// Every square of the cube split along its other diagonal.
Soup cube_split_otherwise() {
  Soup cube = shapes::cube();
  for (std::size_t f = 0; f + 1 < cube.n_faces(); f += 2) {
    // The two faces a b c and a c d of a square, each beginning anywhere.
    Triangle& first = cube.triangles[f];
    Triangle& second = cube.triangles[f + 1];
    const auto has = [](const Triangle& t, Index v) {
      return std::count(t.begin(), t.end(), v) > 0;
    };
    while (has(second, first[1])) std::rotate(first.begin(), first.begin() + 1, first.end());
    while (has(first, second[2])) std::rotate(second.begin(), second.begin() + 1, second.end());
    const Index a = first[0];
    const Index b = first[1];
    const Index c = first[2];
    const Index d = second[2];
    first = {a, b, d};
    second = {b, c, d};
  }
  return cube;
}

TEST(VertexNormals, CubeCornersPointAlongItsDiagonalsHoweverItIsCut) {
  for (const Soup& cube : {shapes::cube(2.0, {-1, -1, -1}), cube_split_otherwise()}) {
    const Vec3 middle = cube.positions[0] / 2 + cube.positions[7] / 2;
    const std::vector<Vec3> normals = normals_of(cube);
    ASSERT_EQ(normals.size(), 8U);
    for (std::size_t v = 0; v < 8; ++v) {
      expect_near(normals[v], (cube.positions[v] - middle).normalized());
    }
  }
}

TEST(VertexNormals, IcosahedronIsRadialBySymmetry) {
  const Soup ball = shapes::icosphere(0);
  for (const NormalWeight weight : kWeights) {
    const std::vector<Vec3> normals = normals_of(ball, weight);
    for (std::size_t v = 0; v < ball.n_vertices(); ++v) {
      expect_near(normals[v], ball.positions[v]);
    }
  }
}

TEST(VertexNormals, CubeCornersLeanWhereTheDiagonalsAreUnlessByAngle) {
  // A side of the cube counts once at a corner, or twice where its diagonal ends there: one or two
  // equal faces, of equal area. Both weights are equation 1 of the laboratory report here.
  const Soup cube = shapes::cube(2.0, {-1, -1, -1});
  std::vector<Vec3> sums(8, Vec3::Zero());
  for (Index f = 0; f < cube.n_faces(); ++f) {
    const auto p = corners_of(cube, f);
    for (const Index v : cube.triangles[f]) sums[v] += (p[1] - p[0]).cross(p[2] - p[0]) / 4;
  }
  for (const NormalWeight weight : {NormalWeight::Uniform, NormalWeight::Area}) {
    const std::vector<Vec3> normals = normals_of(cube, weight);
    for (std::size_t v = 0; v < 8; ++v) expect_near(normals[v], sums[v].normalized());
  }
  EXPECT_TRUE(std::any_of(sums.begin(), sums.end(),
                          [](const Vec3& sum) { return sum.cwiseAbs() != Vec3::Ones(); }));
}

TEST(VertexNormals, EachWeightCountsWhatItSays) {
  // Two faces at the origin: 90 degrees, area 5/2 and normal z; 45 degrees, area 5 and normal x.
  const Soup soup =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 5, 0}, {0, 2, 2}}, {{0, 1, 2}, {0, 2, 3}});
  expect_near(normals_of(soup, NormalWeight::Uniform)[0], Vec3(1, 0, 1).normalized());
  expect_near(normals_of(soup, NormalWeight::Area)[0], Vec3(2, 0, 1).normalized());
  expect_near(normals_of(soup, NormalWeight::Angle)[0], Vec3(1, 0, 2).normalized());
}

TEST(VertexNormals, FineSphereIsNearlyRadial) {
  // Edges are 1.107 / 32 long, or 1.2 times that where the projection stretches them most. A face
  // is tilted from the sphere at its corner by its circumradius, edge / sqrt(3) = 0.024, and a
  // weighted mean by no more.
  const Soup ball = shapes::icosphere(5);
  const std::vector<Vec3> normals = normals_of(ball);
  for (std::size_t v = 0; v < ball.n_vertices(); ++v) {
    EXPECT_NEAR((normals[v] - ball.positions[v]).norm(), 0.0, 0.025);
    EXPECT_NEAR(normals[v].norm(), 1.0, 1e-15);
  }
}

TEST(VertexNormals, AnglesAreTheWeights) {
  // Two faces at the origin: 90 degrees with normal z, 45 degrees with normal x.
  const std::vector<Vec3> normals = normals_of(
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 5, 0}, {0, 2, 2}}, {{0, 1, 2}, {0, 2, 3}}));
  expect_near(normals[0], Vec3(45, 0, 90).normalized());
  expect_near(normals[1], Vec3(0, 0, 1));
  expect_near(normals[3], Vec3(1, 0, 0));
}

TEST(VertexNormals, TurningTheFacesTurnsTheNormals) {
  const Soup torus = shapes::torus(2, 0.5, 12, 9);
  const std::vector<Vec3> normals = normals_of(torus);
  const std::vector<Vec3> turned = normals_of(shapes::flipped(torus));
  for (std::size_t v = 0; v < normals.size(); ++v) {
    expect_near(turned[v], -normals[v]);
  }
}

TEST(VertexNormals, OrphanHasNone) {
  const std::vector<Vec3> normals =
      normals_of(shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}}, {{0, 1, 2}}));
  ASSERT_EQ(normals.size(), 4U);
  EXPECT_EQ(normals[3], Vec3::Zero());
  EXPECT_EQ(normals[0], Vec3(0, 0, 1));
}

TEST(VertexNormals, FacesBackToBackCancel) {
  Soup pillow = shapes::pillow();
  const Eigen::AngleAxisd turn(0.7, Vec3(1, -2, 3).normalized());
  for (Vec3& p : pillow.positions) p = turn * p + Vec3(5, 6, -7);
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    for (const Vec3& normal : normals_of(shapes::shuffled_faces(pillow, seed))) {
      EXPECT_EQ(normal, Vec3::Zero());
    }
  }
}

TEST(VertexNormals, FacesThatCancelButForRoundingLeaveNone) {
  // At vertex 0 a right angle faces up, and two angles that make another face down.
  for (int degrees = 5; degrees < 90; degrees += 5) {
    const double angle = degrees * std::numbers::pi / 180;
    const Soup soup =
        shapes::make({{0, 0, 0}, {1, 0, 0}, {std::cos(angle), std::sin(angle), 0}, {0, 1, 0}},
                     {{0, 1, 3}, {0, 3, 2}, {0, 2, 1}});
    EXPECT_EQ(normals_of(soup)[0], Vec3::Zero()) << degrees;
  }
}

TEST(VertexNormals, ZeroAreaCountsForNothing) {
  // The second face is a line beside the first; its third vertex is on nothing else.
  const std::vector<Vec3> normals = normals_of(shapes::make(
      {{0, 0, 0}, {0.1, 0.1, 0.1}, {1, 0, 0}, {0.7, 0.7, 0.7}}, {{0, 2, 1}, {0, 1, 3}}));
  expect_near(normals[0], Vec3(0, -1, 1).normalized());
  EXPECT_EQ(normals[3], Vec3::Zero());
}

TEST(VertexNormals, CopiesOfAVertexCountTogether) {
  // Three walls on the edge of vertices 0 and 1 (the z axis), turned by 0, 120 and 240 degrees from
  // one another: the mesh holds the ends thrice, and the normals of walls all turned alike cancel.
  const double s = std::numbers::sqrt3 / 2;
  const std::vector<Vec3> corners{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-0.5, s, 0}, {-0.5, -s, 0}};
  const std::vector<Vec3> alike =
      normals_of(shapes::make(corners, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
  ASSERT_EQ(alike.size(), 5U);
  EXPECT_EQ(alike[0], Vec3::Zero());
  EXPECT_EQ(alike[1], Vec3::Zero());
  // One wall turned over: y counts -1 from it, and 1 - 2 cos 60 of the others are against it.
  const std::vector<Vec3> one_turned =
      normals_of(shapes::make(corners, {{1, 0, 2}, {0, 1, 3}, {0, 1, 4}}));
  expect_near(one_turned[0], Vec3(0, -1, 0));
  expect_near(one_turned[1], Vec3(0, -1, 0));
}

TEST(VertexNormals, AnySizeHasTheSameNormals) {
  const Soup torus = shapes::torus(2, 0.5, 12, 9);
  for (const NormalWeight weight : kWeights) {
    const std::vector<Vec3> normals = normals_of(torus, weight);
    for (const double size : {1e-300, 1e-170, 1e-60, 1e60, 1e170, 1e300}) {
      const std::vector<Vec3> scaled = normals_of(shapes::scaled(torus, size), weight);
      for (std::size_t v = 0; v < normals.size(); ++v) {
        expect_near(scaled[v], normals[v]);
      }
    }
  }
}

TEST(VertexNormals, LargeFaceDrownsSmallOnesByAreaAlone) {
  // At the origin a face 1e400 large facing z, and two of 1 facing x and y, both orders.
  for (const std::vector<Triangle>& faces :
       {std::vector<Triangle>{{0, 1, 2}, {0, 3, 4}, {0, 4, 5}},
        std::vector<Triangle>{{0, 4, 5}, {0, 3, 4}, {0, 1, 2}}}) {
    const Soup soup = shapes::make(
        {{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, faces);
    expect_near(normals_of(soup, NormalWeight::Area)[0], Vec3(0, 0, 1));
    expect_near(normals_of(soup, NormalWeight::Uniform)[0], Vec3(1, 1, 1).normalized());
  }
}

TEST(VertexNormals, ZeroAreaBesideTheTiniestCountsForNothing) {
  const Soup soup =
      shapes::make({{0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  for (const NormalWeight weight : kWeights) {
    expect_near(normals_of(soup, weight)[0], Vec3(0, 0, 1));
  }
}

TEST(VertexNormals, NumberOfThreadsDoesNotMatter) {
  const CutMesh cut = build(shapes::torus(3, 1, 200, 100));
  const ThreadLimit one(1);
  const std::vector<Vec3> sequential = vertex_normals(cut);
  const ThreadLimit two(2);
  EXPECT_EQ(vertex_normals(cut), sequential);
}

TEST(VertexNormals, NoVerticesHaveNone) {
  EXPECT_TRUE(normals_of(Soup{}).empty());
}

}  // namespace
}  // namespace meshalyzer
