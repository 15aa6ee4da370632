#include "meshalyzer/mesh/require_records.h"

#include "meshalyzer/base/error.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns why a cube of 8 vertices and 12 faces is refused after a change; empty if it is not.
std::string refusal(const std::function<void(Soup&)>& change) {
  Soup soup = shapes::cube();
  change(soup);
  try {
    require_records(soup);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return {};
}

TEST(RequireRecords, WholeAndEmptyColumnsAreNoFault) {
  EXPECT_EQ(refusal([](Soup&) {}), "");
  EXPECT_EQ(refusal([](Soup& soup) {
              soup.triangles[3][1] = kNoIndex;
              soup.missing = {{3, 1, 99}};
              soup.vertex_ids.named = {1, 2, 3, 4, 5, 6, 7, 9};
              soup.normals = {Vec3(0, 0, 1)};
              soup.corner_normals.assign(12, Triangle{0, kNoIndex, 0});
              // The second group is empty, and so is the last.
              soup.groups = {{"a", 0}, {"b", 5}, {"c", 5}, {"d", 12}};
            }),
            "");
}

TEST(RequireRecords, CornersThatAreNotThereAreNamed) {
  EXPECT_EQ(refusal([](Soup& soup) { soup.triangles[3][1] = 8; }), "face 3 names vertex 8 of 8");
  EXPECT_EQ(refusal([](Soup& soup) {
              soup.normals = {Vec3(0, 0, 1)};
              soup.corner_normals.assign(12, Triangle{0, 1, 0});
            }),
            "face 0 names normal 1 of 1");
}

// As where a mesh that was read gets another vertex, but no id for it.
TEST(RequireRecords, ColumnsWithoutAnEntryForEachRecordAreRefused) {
  EXPECT_EQ(refusal([](Soup& soup) { soup.vertex_ids.named = {1, 2, 3, 4, 5, 6, 7}; }),
            "a soup has 7 ids of vertices for 8");
  EXPECT_EQ(refusal([](Soup& soup) { soup.face_ids.named.assign(11, 1); }),
            "a soup has 11 ids of faces for 12");
  EXPECT_NE(refusal([](Soup& soup) { soup.vertex_lines = {1}; }), "");
  EXPECT_NE(refusal([](Soup& soup) { soup.face_lines = {1}; }), "");
  EXPECT_NE(refusal([](Soup& soup) { soup.corner_normals = {kNoTriangle}; }), "");
}

// As where the last face of a mesh that was read is taken away to open it.
TEST(RequireRecords, EntriesOfRecordsThatWereDroppedAreNoFault) {
  EXPECT_EQ(refusal([](Soup& soup) {
              soup.face_ids.named.assign(12, 1);
              soup.face_lines.assign(12, 1);
              soup.triangles.pop_back();
            }),
            "");
}

TEST(RequireRecords, GroupsAndReferencesAreAtFacesThatAreThere) {
  EXPECT_EQ(refusal([](Soup& soup) {
              soup.groups = {{"a", 4}, {"b", 3}};
            }),
            "the groups of a soup are not in the order of their faces");
  EXPECT_EQ(refusal([](Soup& soup) {
              soup.groups = {{"a", 13}};
            }),
            "a group of a soup begins at face 13 of 12");
  EXPECT_NE(refusal([](Soup& soup) { soup.missing = {{12, 0, 99}}; }), "");
  EXPECT_NE(refusal([](Soup& soup) { soup.missing = {{0, 3, 99}}; }), "");
}

}  // namespace
}  // namespace meshalyzer
