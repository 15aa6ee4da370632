#include "meshalyzer/contour/march_tetrahedra.h"

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "support/random_soups.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace meshalyzer {
namespace {

/// Answers at random, the same for the same question.
class RandomRegion : public Region {
 public:
  explicit RandomRegion(std::uint32_t seed) : seed_(seed) {}
  bool contains(const Vec3& p) const override { return number(p) % 2 == 0; }
  double crossing(const Vec3& inside, const Vec3& outside) const override {
    const std::uint32_t n = number(inside + 3 * outside);
    if (n % 7 == 0) return std::numeric_limits<double>::quiet_NaN();
    if (n % 7 == 1) return std::numeric_limits<double>::infinity();
    return n % 1000 / 500.0 - 0.5;
  }

 private:
  std::uint32_t number(const Vec3& p) const {
    std::seed_seq sequence{seed_, static_cast<std::uint32_t>(std::hash<double>{}(p.x())),
                           static_cast<std::uint32_t>(std::hash<double>{}(p.y() + 0.5)),
                           static_cast<std::uint32_t>(std::hash<double>{}(p.z() + 0.25))};
    std::mt19937 random(sequence);
    return static_cast<std::uint32_t>(random());
  }
  std::uint32_t seed_;
};

/// A ball round the origin.
class Ball : public Region {
 public:
  explicit Ball(double radius) : radius_(radius) {}
  bool contains(const Vec3& p) const override { return p.norm() <= radius_; }
  double crossing(const Vec3& inside, const Vec3& outside) const override {
    double in = 0;
    double out = 1;
    for (int i = 0; i < 50; ++i) {
      (contains(inside + (in + out) / 2 * (outside - inside)) ? in : out) = (in + out) / 2;
    }
    return in;
  }

 private:
  double radius_;
};

Soup soup_of(const Contour& contour) {
  Soup soup;
  soup.positions = contour.positions;
  soup.triangles = contour.triangles;
  return soup;
}

double volume_of(const Contour& contour) {
  double sum = 0;
  for (const Triangle& t : contour.triangles) {
    sum += contour.positions[t[0]].dot(contour.positions[t[1]].cross(contour.positions[t[2]]));
  }
  return sum / 6;
}

void expect_embedded_solid(const Contour& contour) {
  const Soup soup = soup_of(contour);
  const CutMesh cut = build(soup);
  EXPECT_TRUE(cut.side.rejected_faces.empty());
  EXPECT_EQ(cut.side.non_manifold_edges.size(), 0U);
  EXPECT_EQ(cut.side.flipped_edges.size(), 0U);
  EXPECT_TRUE(cut.side.non_manifold_vertices.empty());
  for (const auto h : cut.mesh.halfedges()) ASSERT_FALSE(cut.mesh.is_boundary(h));
  EXPECT_TRUE(find_self_intersections(cut, FaceTree(cut)).empty());
}

BisectionGrid refined_at_random(std::mt19937& random, int n) {
  BisectionGrid grid(Box3(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
  for (int i = 0; i < n; ++i) {
    const auto leaves = grid.leaves();
    grid.bisect(leaves[below(random, static_cast<Index>(leaves.size()))]);
  }
  return grid;
}

TEST(MarchTetrahedra, AnyLabelsAndAnyCrossingsGiveAnEmbeddedSolid) {
  std::mt19937 random(20261122);
  std::size_t n_faces = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const BisectionGrid grid = refined_at_random(random, 150);
    const RandomRegion region(seed);
    const auto leaves = grid.leaves();
    const Contour contour =
        march_tetrahedra(grid, leaves, label_vertices(grid, leaves, region), region);
    expect_embedded_solid(contour);
    EXPECT_GT(volume_of(contour), 0);
    n_faces += contour.triangles.size();
  }
  EXPECT_GT(n_faces, 10'000U);
}

TEST(MarchTetrahedra, OfABallHasItsVolumeAndItsCentreInside) {
  BisectionGrid grid(Box3(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
  for (int level = 0; level < 14; ++level) {
    for (const Index t : grid.leaves()) grid.bisect(t);
  }
  const Ball ball(1);
  const auto leaves = grid.leaves();
  const Contour contour = march_tetrahedra(grid, leaves, label_vertices(grid, leaves, ball), ball);
  expect_embedded_solid(contour);
  EXPECT_NEAR(volume_of(contour), 4 * std::numbers::pi / 3, 0.05);
}

TEST(MarchTetrahedra, WithoutAnyVertexInsideIsEmpty) {
  const BisectionGrid grid(Box3(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
  const Ball nothing(-1);
  const auto leaves = grid.leaves();
  EXPECT_TRUE(march_tetrahedra(grid, leaves, label_vertices(grid, leaves, nothing), nothing)
                  .triangles.empty());
}

TEST(LabelVertices, AskNothingAgainThatIsKnown) {
  BisectionGrid grid(Box3(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
  for (int level = 0; level < 4; ++level) {
    for (const Index t : grid.leaves()) grid.bisect(t);
  }
  const auto leaves = grid.leaves();
  const GridLabels all = label_vertices(grid, leaves, Ball(10));
  EXPECT_EQ(label_vertices(grid, leaves, Ball(-1), all).inside, all.inside);
}

}  // namespace
}  // namespace meshalyzer
