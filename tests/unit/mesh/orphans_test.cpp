#include "meshalyzer/mesh/orphans.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(FindOrphanVertices, EveryVertexOfACubeIsUsed) {
  EXPECT_TRUE(find_orphan_vertices(shapes::cube(), {}).empty());
}

TEST(FindOrphanVertices, AreThoseThatNoFaceNames) {
  Soup soup = shapes::cube();
  soup.positions.insert(soup.positions.end(), 2, Vec3(9, 9, 9));
  soup.triangles.push_back({0, 1, kNoIndex});
  EXPECT_EQ(find_orphan_vertices(soup, {}), (std::vector<Index>{8, 9}));
}

TEST(FindOrphanVertices, RecordThatRepeatsAnIdIsNone) {
  Soup soup = shapes::cube();
  soup.positions.insert(soup.positions.end(), 2, Vec3(9, 9, 9));
  EXPECT_EQ(find_orphan_vertices(soup, std::vector<Index>{8}), (std::vector<Index>{9}));
}

}  // namespace
}  // namespace meshalyzer
