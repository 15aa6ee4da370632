#include "meshalyzer/repair/passes.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace meshalyzer {
namespace {

/// One normal a vertex, as PLY and OFF give them: away from the middle of the unit cube.
Soup cube_with_normals() {
  Soup soup = shapes::cube();
  soup.format = Format::Ply;
  for (const Vec3& p : soup.positions) soup.normals.push_back(p - Vec3::Constant(0.5));
  soup.corner_normals = soup.triangles;
  return soup;
}

TEST(RenewNormals, NormalsThatPointOutwardAreLeftThoughTheyAreNotUnit) {
  EXPECT_EQ(run_pass(cube_with_normals(), renew_normals).operations, 0U);
  EXPECT_EQ(run_pass(Soup{}, renew_normals).operations, 0U);
  EXPECT_EQ(run_pass(shapes::cube(), renew_normals).operations, 0U);
}

TEST(RenewNormals, NormalOpposedToSomeFacesOnlyIsLeft) {
  Soup soup = cube_with_normals();
  soup.normals[0] = {-1, 2, 2};
  EXPECT_EQ(run_pass(soup, renew_normals).operations, 0U);
}

TEST(RenewNormals, OpposedNormalBecomesThatOfTheFacesAndNoOtherChanges) {
  const Soup right = cube_with_normals();
  Soup wrong = right;
  wrong.normals[0] *= -1;
  const PassRun run = run_pass(wrong, renew_normals);
  EXPECT_EQ(run.operations, 1U);
  EXPECT_EQ(run.rounds, 1U);
  // The three sides at a corner of a cube weigh the same, however they are cut into triangles.
  Soup fixed = run.tracked.soup;
  ASSERT_EQ(fixed.normals.size(), 8U);
  EXPECT_LT((fixed.normals[0] - Vec3::Constant(-1.0 / std::sqrt(3.0))).norm(), 1e-15);
  fixed.normals[0] = right.normals[0];
  EXPECT_TRUE(same_soup(fixed, right));
}

TEST(RenewNormals, AllNormalsOfAMeshInsideOutAreRenewed) {
  Soup inside_out = shapes::flipped(cube_with_normals());
  inside_out.corner_normals = inside_out.triangles;
  const PassRun run = run_pass(inside_out, renew_normals);
  EXPECT_EQ(run.operations, 8U);
  for (std::size_t v = 0; v < run.tracked.soup.n_vertices(); ++v) {
    const Vec3 inward = Vec3::Constant(0.5) - run.tracked.soup.positions[v];
    EXPECT_LT((run.tracked.soup.normals[v] - inward.normalized()).norm(), 1e-15);
  }
}

TEST(RenewNormals, HardEdgesStayHard) {
  // Each face has its own normal at its corners; one of those at vertex 7 is wrong.
  Soup soup = shapes::cube();
  soup.format = Format::Obj;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const auto [a, b, c] = corners_of(soup, f);
    soup.normals.push_back((b - a).cross(c - a).normalized());
    soup.corner_normals.push_back({f, f, f});
  }
  const std::vector<Vec3> right = soup.normals;
  soup.normals.emplace_back(-1, -1, -1);
  const auto wrong =
      std::find_if(soup.triangles.begin(), soup.triangles.end(),
                   [](const Triangle& t) { return std::find(t.begin(), t.end(), 7U) != t.end(); });
  const auto face = static_cast<std::size_t>(wrong - soup.triangles.begin());
  const auto corner =
      static_cast<std::size_t>(std::find(wrong->begin(), wrong->end(), 7U) - wrong->begin());
  soup.corner_normals[face][corner] = 12;
  ASSERT_EQ(soup.positions[7], Vec3(1, 1, 1));
  const PassRun run = run_pass(soup, renew_normals);
  EXPECT_EQ(run.operations, 1U);
  for (Index f = 0; f < soup.n_faces(); ++f) {
    for (const Index normal : run.tracked.soup.corner_normals[f]) {
      EXPECT_EQ(run.tracked.soup.normals[normal], right[f]);
    }
  }
}

TEST(RenewNormals, VertexBetweenFacesBackToBackIsLeft) {
  // The normal is opposed to one of them, but not to both.
  Soup pillow = shapes::pillow();
  pillow.normals = {{0, 0, 1}};
  pillow.corner_normals = {{0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(run_pass(pillow, renew_normals).operations, 0U);
}

TEST(RenewNormals, NormalIsRefusedWhereThoseOfTheFacesCancelEachOther) {
  // The edge of a wedge of 2e-14 radians: the normals of its sides are (-1e-14, 0, 1) and
  // (-1e-14, 0, -1), and the one given there is opposed to both.
  Soup wedge = shapes::make({{0, 0, 0}, {0, 1, 0}, {1, 0.5, 1e-14}, {1, 0.5, -1e-14}},
                            {{0, 2, 1}, {0, 1, 3}});
  wedge.normals = {{1, 0, 0}};
  wedge.corner_normals = {{0, kNoIndex, kNoIndex}, {0, kNoIndex, kNoIndex}};
  const PassRun run = run_pass(wedge, renew_normals);
  EXPECT_EQ(run.operations, 0U);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].code, DefectCode::VertexNormal);
  EXPECT_EQ(run.refused[0].vertex, 0U);
}

}  // namespace
}  // namespace meshalyzer
