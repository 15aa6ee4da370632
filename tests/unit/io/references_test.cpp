#include "meshalyzer/io/references.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/mesh_format.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

Soup soup_with_ids(std::vector<std::int32_t> ids, std::vector<Triangle> faces_by_id) {
  Soup soup;
  soup.positions.resize(ids.size(), Vec3(0, 0, 0));
  soup.vertex_ids = compact_ids(std::move(ids));
  soup.triangles = std::move(faces_by_id);
  resolve_ids(soup);
  return soup;
}

TEST(CompactIds, KeepNoListWhereTheyCount) {
  const Ids ids = compact_ids({5, 6, 7});
  EXPECT_TRUE(ids.named.empty());
  EXPECT_EQ(ids.first, 5);
}

TEST(CompactIds, KeepTheListWhereTheyDoNot) {
  EXPECT_EQ(compact_ids({5, 7, 6}).named, (std::vector<std::int32_t>{5, 7, 6}));
}

TEST(ResolveIds, OfCountingIdsSubtractTheFirst) {
  const Soup soup = soup_with_ids({5, 6, 7}, {{7, 5, 6}});
  EXPECT_EQ(soup.triangles[0], (Triangle{2, 0, 1}));
  EXPECT_TRUE(soup.missing.empty());
}

TEST(ResolveIds, OfScatteredIdsFindTheirRecords) {
  const Soup soup = soup_with_ids({9, 2, 4}, {{2, 4, 9}});
  EXPECT_EQ(soup.triangles[0], (Triangle{1, 2, 0}));
}

TEST(ResolveIds, OfTheLargestIdsNeedNoLargeTable) {
  const Soup soup =
      soup_with_ids({2147483647, 1, 1000000000}, {{1, 2147483647, 1000000000}, {1, 2, 1}});
  EXPECT_EQ(soup.triangles[0], (Triangle{1, 0, 2}));
  EXPECT_EQ(soup.triangles[1], (Triangle{1, kNoIndex, 1}));
}

TEST(ResolveIds, TheFirstRecordOfAnIdCounts) {
  EXPECT_EQ(soup_with_ids({3, 1, 3, 1}, {{3, 1, 1}}).triangles[0], (Triangle{0, 1, 1}));
  EXPECT_EQ(soup_with_ids({2000000000, 1, 2000000000}, {{2000000000, 1, 1}}).triangles[0],
            (Triangle{0, 1, 1}));
}

TEST(ResolveIds, MissingOnesAreListedByFaceAndCorner) {
  const Soup soup = soup_with_ids({1, 2}, {{1, 2, 3}, {4, 1, 3}});
  ASSERT_EQ(soup.missing.size(), 3U);
  EXPECT_EQ(soup.missing[0].face, 0U);
  EXPECT_EQ(soup.missing[0].corner, 2);
  EXPECT_EQ(soup.missing[0].id, 3);
  EXPECT_EQ(soup.missing[1].id, 4);
  EXPECT_EQ(soup.missing[2].corner, 2);
  EXPECT_EQ(soup.triangles[1], (Triangle{kNoIndex, 0, kNoIndex}));
}

TEST(AppendFan, TurnsAPolygonAboutItsFirstCorner) {
  std::vector<Triangle> triangles;
  append_fan(triangles, {7, 8, 9, 10, 11});
  EXPECT_EQ(triangles, (std::vector<Triangle>{{7, 8, 9}, {7, 9, 10}, {7, 10, 11}}));
}

TEST(AppendFan, KeepsTooFewCornersAsADegenerateTriangle) {
  std::vector<Triangle> triangles;
  append_fan(triangles, {7, 8});
  append_fan(triangles, {7});
  EXPECT_EQ(triangles, (std::vector<Triangle>{{7, 8, 8}, {7, 7, 7}}));
}

TEST(RequireAllVertices, NamesTheFaceThatLacksOne) {
  const Soup soup = soup_with_ids({1, 2, 3}, {{1, 2, 3}, {1, 2, 4}});
  EXPECT_THROW(require_all_vertices(soup), InvalidArgument);
}

TEST(RequireUnambiguousIds, RefusesAFaceThatWouldGetAnEarlierVertex) {
  Soup soup = soup_with_ids({1, 2, 3, 2}, {{1, 2, 3}});
  EXPECT_NO_THROW(require_unambiguous_ids(soup));
  soup.triangles[0][1] = 3;
  EXPECT_THROW(require_unambiguous_ids(soup), InvalidArgument);
  EXPECT_THROW(static_cast<void>(print_mesh_format(soup)), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
