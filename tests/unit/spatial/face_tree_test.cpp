#include "meshalyzer/spatial/face_tree.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

/// Tells whether node `i` of a level, as boxed by its parent, holds all boxes of its own.
bool parent_holds_child(const FaceTree& tree, std::size_t level, std::size_t i) {
  const TreeBox box = TreeBox::around(tree.node(level - 1, i));
  const EightBoxes& parent = tree.node(level, i / 8);
  for (std::size_t k = 0; k < 3; ++k) {
    if (box.low[k] < parent.min[k][i % 8] || box.high[k] > parent.max[k][i % 8]) {
      return false;
    }
  }
  return true;
}

TEST(FaceTree, HoldsEveryFaceOnce) {
  const CutMesh cut = build(shapes::uv_sphere(17, 23));
  const FaceTree tree(cut);
  ASSERT_EQ(tree.n_faces(), cut.mesh.n_faces());
  std::vector<int> seen(tree.n_faces(), 0);
  for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
    ++seen[tree.mesh_face(slot)];
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
}

TEST(FaceTree, OfSomeFacesHoldsTheseOnce) {
  const CutMesh cut = build(shapes::uv_sphere(17, 23));
  const FaceTree all(cut);
  std::vector<Triangle> corners(cut.mesh.n_faces());
  for (std::size_t slot = 0; slot < all.n_faces(); ++slot) {
    corners[all.mesh_face(slot)] = all.triangle(slot);
  }
  std::vector<Index> some;
  for (Index f = 5; f < cut.mesh.n_faces(); f += 3) some.push_back(f);
  const FaceTree tree(cut, some);
  std::vector<Index> held;
  for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
    held.push_back(tree.mesh_face(slot));
    EXPECT_EQ(tree.triangle(slot), corners[tree.mesh_face(slot)]);
  }
  std::sort(held.begin(), held.end());
  EXPECT_EQ(held, some);
  EXPECT_EQ(FaceTree(cut, {}).n_faces(), 0U);
}

TEST(FaceTree, FewFarFacesLeaveTheOthersTheirPlaces) {
  Soup soup = shapes::uv_sphere(17, 23);
  EXPECT_FALSE(FaceTree(build(soup)).has_far_faces());
  const Vec3 near_far = soup.positions[60];
  soup.positions[60] = {1e28, 0, 0};
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  EXPECT_TRUE(tree.has_far_faces());
  EXPECT_TRUE(tree.is_far(soup.positions[60]));
  EXPECT_FALSE(tree.is_far(near_far));
  EXPECT_EQ(tree.map(soup.positions[60])[0], 2.0F);
  EXPECT_GT(tree.map({0.5, 0, 0})[0], tree.map({0.499, 0, 0})[0]);
  // Each leaf without far faces has a part of the sphere, and no more.
  std::size_t n_far = 0;
  for (std::size_t leaf = 0; leaf < tree.n_leaves(); ++leaf) {
    const TreeBox box = TreeBox::around(tree.node(0, leaf));
    EXPECT_EQ(tree.is_far_leaf(leaf), box.high[0] == 2.0F);
    n_far += tree.is_far_leaf(leaf) ? 1 : 0;
    EXPECT_TRUE(tree.is_far_leaf(leaf) || box.high[0] - box.low[0] < 0.15F);
  }
  EXPECT_GT(n_far, 0U);
  EXPECT_LT(n_far, 7U);
}

TEST(FaceTree, ManyFarFacesAreNotFar) {
  const Soup two = shapes::merged(shapes::uv_sphere(30, 40),
                                  shapes::translated(shapes::uv_sphere(30, 20), {1e9, 0, 0}));
  EXPECT_FALSE(FaceTree(build(two)).has_far_faces());
}

TEST(FaceTree, BoxesHoldTheCornersOfTheirFaces) {
  const CutMesh cut = build(shapes::translated(shapes::torus(2, 0.5, 30, 20), {1e6, -1e3, 7}));
  const FaceTree tree(cut);
  for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
    for (const Index v : tree.triangle(slot)) {
      const auto p = tree.map(tree.point(v));
      ASSERT_TRUE((tree.node(0, slot / 8).meeting({p, p}) >> (slot % 8)) & 1U) << "slot " << slot;
    }
  }
}

TEST(FaceTree, NodesHoldTheirChildren) {
  const CutMesh cut = build(shapes::uv_sphere(40, 40));
  const FaceTree tree(cut);
  ASSERT_GE(tree.n_levels(), 4u);
  for (std::size_t level = 1; level < tree.n_levels(); ++level) {
    const std::size_t children =
        (tree.n_leaves() + (1U << (3 * (level - 1))) - 1) >> (3 * (level - 1));
    for (std::size_t i = 0; i < children; ++i) {
      ASSERT_TRUE(parent_holds_child(tree, level, i)) << "level " << level << " child " << i;
    }
  }
}

TEST(FaceTree, MapIsMonotoneWhereDoublesAreFinerThanFloats) {
  const CutMesh cut = build(shapes::cube(1.0, {0, 0, 0}));
  const FaceTree tree(cut);
  double x = 0.3;
  for (int i = 0; i < 1000; ++i) {
    const double next = std::nextafter(x, 1.0);
    ASSERT_LE(tree.map({x, 0, 0})[0], tree.map({next, 0, 0})[0]);
    x = next;
  }
}

TEST(FaceTree, LargestDoublesDoNotOverflowIt) {
  const double big = std::numeric_limits<double>::max();
  const CutMesh cut = build(shapes::make({{-big, 0, 0}, {big, 0, 0}, {0, big, -big}}, {{0, 1, 2}}));
  const FaceTree tree(cut);
  for (const Index v : tree.triangle(0)) {
    for (const float coordinate : tree.map(tree.point(v))) {
      EXPECT_LE(std::abs(coordinate), 1.5F);
    }
  }
}

TEST(EightBoxes, EmptyBoxesMeetNothing) {
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(EightBoxes::empty().meeting({{-2, -2, -2}, {2, 2, 2}}), 0u);
  EXPECT_EQ(EightBoxes::empty().meeting({{0, 0, 0}, {inf, 0, 0}}), 0u) << "a ray along x";
}

TEST(EightBoxes, BoxesThatShareACornerMeet) {
  EightBoxes boxes = EightBoxes::empty();
  for (std::size_t k = 0; k < 3; ++k) {
    boxes.min[k][5] = 0.0F;
    boxes.max[k][5] = 1.0F;
  }
  EXPECT_EQ(boxes.meeting({{1, 1, 1}, {2, 2, 2}}), 1U << 5);
  EXPECT_EQ(boxes.meeting({{1.0001F, 1, 1}, {2, 2, 2}}), 0U);
}

}  // namespace
}  // namespace meshalyzer
