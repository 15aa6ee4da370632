#include "meshalyzer/spatial/slab_tree.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"
#include "support/sliver_tube.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace meshalyzer {
namespace {

bool has_slabs(const Soup& soup) {
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  return SlabTree(tree).has_useful();
}

TEST(SlabTree, IsForBundlesOfLongFacesAskewToTheAxes) {
  EXPECT_TRUE(has_slabs(test::sliver_tube(60, {20, 22, 18})));
  // Boxes fit the same bundle along an axis.
  EXPECT_FALSE(has_slabs(test::sliver_tube(60, {35, 0, 0})));
  EXPECT_FALSE(has_slabs(shapes::torus(2, 0.5, 30, 20)));
}

TEST(SlabTree, ExcludesOnlyFacesBesideTheBundle) {
  const CutMesh cut = build(test::sliver_tube(60, {20, 22, 18}));
  const FaceTree tree(cut);
  const SlabTree slabs(tree);
  ASSERT_TRUE(slabs.has_useful());
  std::size_t n_excluded = 0;
  for (std::size_t a = 0; a < tree.n_leaves(); ++a) {
    const Slabs& bundle = slabs.slabs(0, a);
    if (!bundle.is_useful) continue;
    EXPECT_FALSE(bundle.exclude(LeafTriangles(tree, a))) << "its own faces";
    for (std::size_t b = 0; b < tree.n_leaves(); ++b) {
      n_excluded += bundle.exclude(LeafTriangles(tree, b)) ? 1 : 0;
    }
  }
  EXPECT_GT(n_excluded, 0u);
}

}  // namespace
}  // namespace meshalyzer
