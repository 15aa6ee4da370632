#include "meshalyzer/spatial/fan_tree.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace meshalyzer {
namespace {

/// A flat disk of n faces round vertex 0, with a rim of radius 1 about the origin.
Soup disk(Index n) {
  Soup soup;
  soup.positions.push_back(Vec3::Zero());
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    soup.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    soup.triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  return soup;
}

TEST(FanTree, KnowsTheHubOfEveryNodeOfADisk) {
  const CutMesh cut = build(disk(200));  // 25 leaves, 4 nodes, the root
  const FaceTree tree(cut);
  ASSERT_EQ(tree.n_levels(), 3u);
  const FanTree fans(tree);
  for (std::size_t level = 0, nodes = 25; level < 3; ++level, nodes = (nodes + 7) / 8) {
    for (std::size_t i = 0; i < nodes; ++i) EXPECT_EQ(fans.fan(level, i).hub, 0u);
  }
  // The rim of the root is that of the disk, in the tree's coordinates, which are centred at it.
  const TreeBox& rim = fans.fan(2, 0).rim;
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(rim.low[k], -1.0F);
    EXPECT_EQ(rim.high[k], 1.0F);
  }
}

TEST(FanTree, TellsOppositePartsOfADiskApart) {
  const CutMesh cut = build(disk(200));
  const FaceTree tree(cut);
  const FanTree fans(tree);
  const auto box = [&](std::size_t leaf) { return TreeBox::around(tree.node(0, leaf)); };
  const auto are_apart = [&](std::size_t a, std::size_t b) {
    return FanTree::meet_at_hub_only(fans.fan(0, a), box(a), fans.fan(0, b), box(b));
  };
  EXPECT_FALSE(are_apart(0, 0));
  // The leaves follow each other as the tree splits the disk, so that the first and the last are on
  // different sides of it.
  EXPECT_TRUE(are_apart(0, 24));
}

TEST(FanTree, HasNoHubWhereFacesHaveNoVertexInCommon) {
  const CutMesh cut = build(shapes::grid(20, 20));
  const FaceTree tree(cut);
  const FanTree fans(tree);
  for (std::size_t leaf = 0; leaf < tree.n_leaves(); ++leaf) {
    EXPECT_EQ(fans.fan(0, leaf).hub, kNoIndex);
  }
}

}  // namespace
}  // namespace meshalyzer
