#include "meshalyzer/repair/passes.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::int32_t kLargestId = std::numeric_limits<std::int32_t>::max();

TEST(DropCorrupt, WholeMeshIsLeft) {
  EXPECT_TRUE(same_soup(run_pass(shapes::cube(), drop_corrupt).tracked.soup, shapes::cube()));
  EXPECT_EQ(run_pass(Soup{}, drop_corrupt).operations, 0U);
}

TEST(DropCorrupt, FaceWithAMissingCornerIsDropped) {
  Soup soup = shapes::cube();
  soup.triangles.push_back({0, kNoIndex, 2});
  soup.missing.push_back({12, 1, 99});
  const PassRun run = run_pass(soup, drop_corrupt);
  EXPECT_TRUE(same_soup(run.tracked.soup, shapes::cube()));
  EXPECT_TRUE(run.tracked.soup.missing.empty());
}

TEST(DropCorrupt, FaceThatRepeatsAVertexIsForOthers) {
  Soup soup = shapes::cube();
  soup.triangles.push_back({0, 0, 2});
  EXPECT_TRUE(same_soup(run_pass(soup, drop_corrupt).tracked.soup, soup));
}

TEST(DropCorrupt, LaterRecordsOfAVertexIdAreDropped) {
  Soup soup = shapes::tetrahedron();
  soup.vertex_ids.named = {7, 2, 3, 4, 7, 7};
  soup.positions.emplace_back(8, 8, 8);
  soup.positions.emplace_back(9, 9, 9);
  const PassRun run = run_pass(soup, drop_corrupt);
  EXPECT_EQ(run.tracked.soup.positions, shapes::tetrahedron().positions);
  EXPECT_EQ(run.tracked.soup.triangles, shapes::tetrahedron().triangles);
  EXPECT_EQ(run.tracked.soup.vertex_ids.of(0), 7);
}

TEST(DropCorrupt, LaterRecordsOfAFaceIdGetThoseAfterTheLargest) {
  Soup soup = shapes::tetrahedron();
  soup.face_ids.named = {5, 9, 5, 5};
  const PassRun run = run_pass(soup, drop_corrupt);
  EXPECT_EQ(run.tracked.soup.face_ids.named, (std::vector<std::int32_t>{5, 9, 10, 11}));
  EXPECT_EQ(run.tracked.soup.triangles, soup.triangles);
}

TEST(DropCorrupt, WithoutLargerIdsTheSmallestFreeOnesAreTaken) {
  Soup soup = shapes::tetrahedron();
  soup.face_ids.named = {kLargestId, 1, kLargestId, 1};
  const PassRun run = run_pass(soup, drop_corrupt);
  EXPECT_EQ(run.tracked.soup.face_ids.named, (std::vector<std::int32_t>{kLargestId, 1, 2, 3}));
}

}  // namespace
}  // namespace meshalyzer
