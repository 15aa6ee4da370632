#include "meshalyzer/defects/finders.h"
#include "support/constants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<Index> opposed_in(const Soup& soup) {
  std::vector<Index> vertices;
  for (const Defect& defect : find_opposed_normals(PreparedMesh(soup))) {
    EXPECT_EQ(defect.code, DefectCode::VertexNormal);
    EXPECT_EQ(defect.severity, Severity::Warning);
    EXPECT_EQ(defect.vertices.size(), 1U);
    EXPECT_EQ(defect.positions, std::vector<Vec3>{soup.positions[defect.vertices[0]]});
    vertices.push_back(defect.vertices[0]);
  }
  return vertices;
}

/// A cube about the origin, with the positions of its vertices as their normals.
Soup cube_with_normals() {
  Soup soup = shapes::cube(2.0, Vec3(-1, -1, -1));
  soup.normals = soup.positions;
  soup.corner_normals = soup.triangles;
  return soup;
}

/// A grid in z = 0, facing up, each vertex with this normal.
Soup grid_with_normal(const Vec3& normal) {
  Soup soup = shapes::grid(2, 2);
  soup.normals.assign(soup.n_vertices(), normal);
  soup.corner_normals = soup.triangles;
  return soup;
}

TEST(FindOpposedNormals, MeshWithoutNormalsHasNone) {
  EXPECT_TRUE(opposed_in(shapes::cube()).empty());
  EXPECT_TRUE(opposed_in({}).empty());
}

TEST(FindOpposedNormals, OutwardNormalsAreNot) {
  EXPECT_TRUE(opposed_in(cube_with_normals()).empty());
}

TEST(FindOpposedNormals, NormalIntoTheMeshIs) {
  Soup soup = cube_with_normals();
  soup.normals[2] = -soup.normals[2];
  soup.normals[5] = -0.001 * soup.normals[5];
  EXPECT_EQ(opposed_in(soup), (std::vector<Index>{2, 5}));
}

TEST(FindOpposedNormals, NormalThatOneFaceAgreesWithIsNot) {
  Soup soup = cube_with_normals();
  // Into the cube from the corner along x and y, but out of it along z.
  const Vec3 corner = soup.positions[2];
  soup.normals[2] = Vec3(-corner.x(), -corner.y(), 1e-12 * corner.z());
  EXPECT_TRUE(opposed_in(soup).empty());
  soup.normals[2].z() *= -1.0;
  EXPECT_EQ(opposed_in(soup), std::vector<Index>{2});
}

TEST(FindOpposedNormals, NormalAlongTheFacesIsNot) {
  EXPECT_TRUE(opposed_in(grid_with_normal({1, 0, 0})).empty());
  EXPECT_TRUE(opposed_in(grid_with_normal({1, 0, 1e-300})).empty());
  EXPECT_EQ(opposed_in(grid_with_normal({1, 0, -1e-300})).size(), 9U);
}

TEST(FindOpposedNormals, NormalThatSaysNothingIsNot) {
  EXPECT_TRUE(opposed_in(grid_with_normal({0, 0, 0})).empty());
  EXPECT_TRUE(opposed_in(grid_with_normal({0, 0, -kInfinity})).empty());
  EXPECT_TRUE(opposed_in(grid_with_normal({0, 0, std::nan("")})).empty());
}

TEST(FindOpposedNormals, AnyOfSeveralNormalsAtAVertexCounts) {
  Soup soup = cube_with_normals();
  soup.normals.push_back(-soup.positions[soup.triangles[7][1]]);
  soup.corner_normals[7][1] = 8;
  EXPECT_EQ(opposed_in(soup), std::vector<Index>{soup.triangles[7][1]});
}

TEST(FindOpposedNormals, CornersWithoutANormalSayNothing) {
  Soup soup = cube_with_normals();
  soup.normals[2] = -soup.normals[2];
  for (Triangle& corners : soup.corner_normals) {
    for (Index& normal : corners) normal = normal == 2 ? kNoIndex : normal;
  }
  EXPECT_TRUE(opposed_in(soup).empty());
}

TEST(FindOpposedNormals, FacesOfZeroAreaHaveNoSay) {
  // The second face has no area; its normals are opposed to the first, or free.
  Soup soup =
      shapes::make({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)},
                   {{0, 1, 2}, {0, 3, 4}});
  soup.normals = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  soup.corner_normals = {{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(opposed_in(soup), std::vector<Index>{0});
  soup.corner_normals = {{0, 1, 0}, {0, 1, 1}};
  EXPECT_EQ(opposed_in(soup), std::vector<Index>{1});
}

TEST(FindOpposedNormals, FacesThatAreNotInTheComplexHaveNoSay) {
  Soup soup = shapes::make({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                           {{0, 1, 2}, {0, 1, 1}, {2, 1, kNoIndex}});
  soup.normals = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  soup.corner_normals = {{1, 0, 0}, {1, 0, 0}, {1, 0, kNoIndex}};
  EXPECT_EQ(opposed_in(soup), (std::vector<Index>{0, 2}));
}

TEST(FindOpposedNormals, AllFansOfAPinchedVertexHaveASay) {
  Soup soup =
      shapes::merged(shapes::make({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}),
                     shapes::make({Vec3(-1, 0, 0), Vec3(0, -1, 0)}, {}));
  soup.triangles.push_back({0, 4, 3});  // Clockwise: faces down, while the first faces up.
  soup.normals = {Vec3(0, 0, -1)};
  soup.corner_normals = {{0, kNoIndex, kNoIndex}, {kNoIndex, kNoIndex, kNoIndex}};
  EXPECT_TRUE(opposed_in(soup).empty());
  std::swap(soup.triangles[1][1], soup.triangles[1][2]);
  EXPECT_EQ(opposed_in(soup), std::vector<Index>{0});
}

TEST(FindOpposedNormals, VertexOfVeryManyFacesAndNormalsTakesNotTheSquareOfThem) {
  // Only the last of the faces round the apex agrees with all the normals.
  constexpr Index kSides = 20000;
  Soup soup = shapes::make({Vec3(0, 0, 0)}, {});
  for (Index i = 0; i <= kSides; ++i) {
    const double angle = 1e-4 * i;
    soup.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    soup.normals.emplace_back(0.0, 0.0, -1.0 - i);
  }
  for (Index i = 1; i <= kSides; ++i) {
    soup.triangles.push_back({0, i, i + 1});
    soup.corner_normals.push_back({i, kNoIndex, kNoIndex});
  }
  soup.triangles.push_back({0, 3, 1});
  soup.corner_normals.push_back({kNoIndex, kNoIndex, kNoIndex});
  const PreparedMesh mesh(soup);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(find_opposed_normals(mesh).empty());
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

}  // namespace
}  // namespace meshalyzer
