#include "meshalyzer/repair/passes.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

TEST(Renumber, ContiguousIdsAreLeft) {
  EXPECT_EQ(run_pass(shapes::cube(), renumber).operations, 0U);
}

TEST(Renumber, IdsBecomeThePlacesInTheFile) {
  Soup soup = shapes::tetrahedron();
  soup.vertex_ids.named = {3, 2, 9, -4};
  soup.face_ids.first = 0;
  EXPECT_TRUE(same_soup(run_pass(soup, renumber).tracked.soup, shapes::tetrahedron()));
}

TEST(Renumber, VerticesKeepTheirIdsWhereAFaceNamesOneThatIsMissing) {
  Soup soup = shapes::tetrahedron();
  soup.vertex_ids.named = {3, 2, 9, 4};
  soup.face_ids.named = {4, 3, 2, 1};
  soup.triangles[0][1] = kNoIndex;
  // Vertex 1 is missing, and would exist if they were numbered anew.
  soup.missing.push_back({0, 1, 1});
  const PassRun run = run_pass(soup, renumber);
  EXPECT_EQ(run.tracked.soup.vertex_ids.named, soup.vertex_ids.named);
  EXPECT_EQ(run.tracked.soup.face_ids.of(0), 1);
  ASSERT_EQ(run.refused.size(), 1U);
  EXPECT_EQ(run.refused[0].face, 0U);
}

TEST(Renumber, FormatsWithoutIdsAreLeft) {
  Soup soup = shapes::cube();
  soup.format = Format::Off;
  soup.vertex_ids.first = 0;
  EXPECT_EQ(run_pass(soup, renumber).operations, 0U);
}

}  // namespace
}  // namespace meshalyzer
