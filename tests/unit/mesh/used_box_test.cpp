#include "meshalyzer/mesh/used_box.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(UsedBox, OnlyVerticesOfFacesInTheComplexCount) {
  Soup soup = shapes::cube(2.0, Vec3(1, 1, 1));
  soup.positions.emplace_back(100, 100, 100);
  soup.triangles.push_back({8, 8, 0});
  soup.triangles.push_back({8, 1, kNoIndex});
  const Box3 box = used_box(soup);
  EXPECT_EQ(box.min(), Vec3(1, 1, 1));
  EXPECT_EQ(box.max(), Vec3(3, 3, 3));
}

TEST(UsedBox, IsEmptyWithoutFaces) {
  EXPECT_TRUE(used_box({}).isEmpty());
  EXPECT_TRUE(used_box(shapes::make({Vec3(1, 2, 3)}, {})).isEmpty());
}

TEST(UsedExtent, IsTheLongestSideOfTheBox) {
  EXPECT_EQ(used_extent(shapes::box(Vec3(1, 2, 3), Vec3(2, 7, 6))), 5.0);
  EXPECT_EQ(used_extent({}), 0.0);
}

}  // namespace
}  // namespace meshalyzer
