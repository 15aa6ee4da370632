#include "meshalyzer/defects/finders.h"
#include "support/constants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

TEST(FindCorrupt, MeshIsNot) {
  EXPECT_TRUE(find_corrupt({}).empty());
  EXPECT_TRUE(find_corrupt(shapes::cube()).empty());
}

TEST(FindCorrupt, IdsThatAreOnlyOutOfOrderAreNot) {
  Soup soup = shapes::tetrahedron();
  soup.vertex_ids.named = {4, 2, 9, 1};
  soup.face_ids.named = {40, 20, 90, 10};
  EXPECT_TRUE(find_corrupt(soup).empty());
}

TEST(FindCorrupt, EveryMissingIdIsOneDefectWithTheFacesThatNameIt) {
  Soup soup = shapes::tetrahedron();
  const Vec3 corner = soup.positions[soup.triangles[1][0]];
  soup.triangles[1] = {soup.triangles[1][0], kNoIndex, kNoIndex};
  soup.triangles[2][0] = kNoIndex;
  soup.triangles[3] = {kNoIndex, kNoIndex, kNoIndex};
  soup.missing = {{1, 1, 70}, {1, 2, 70}, {2, 0, 60}, {3, 0, 50}, {3, 1, 70}, {3, 2, 50}};
  const DefectList defects = find_corrupt(soup);
  ASSERT_EQ(defects.size(), 3U);
  EXPECT_EQ(defects[0].code, DefectCode::Corrupt);
  EXPECT_EQ(defects[0].severity, Severity::Error);
  EXPECT_EQ(defects[0].detail, "there is no vertex 70");
  EXPECT_EQ(defects[0].faces, (std::vector<Index>{1, 3}));
  EXPECT_EQ(defects[0].positions, std::vector<Vec3>{corner});
  EXPECT_TRUE(defects[0].fixable);
  EXPECT_EQ(defects[1].detail, "there is no vertex 60");
  EXPECT_EQ(defects[1].faces, std::vector<Index>{2});
  EXPECT_EQ(defects[2].detail, "there is no vertex 50");
  EXPECT_EQ(defects[2].faces, std::vector<Index>{3});
  EXPECT_TRUE(defects[2].positions.empty());
}

TEST(FindCorrupt, EveryRepeatedIdIsOneDefectWithAllItsRecords) {
  Soup soup = shapes::tetrahedron();
  soup.vertex_ids.named = {5, 3, 5, 5};
  soup.face_ids.named = {8, 2, 2, 8};
  const DefectList defects = find_corrupt(soup);
  ASSERT_EQ(defects.size(), 3U);
  EXPECT_EQ(defects[0].detail, "vertex id 5 is given more than once");
  EXPECT_EQ(defects[0].vertices, (std::vector<Index>{0, 2, 3}));
  EXPECT_EQ(defects[0].positions,
            (std::vector<Vec3>{soup.positions[0], soup.positions[2], soup.positions[3]}));
  EXPECT_EQ(defects[0].value, 3.0);
  EXPECT_EQ(defects[1].detail, "face id 8 is given more than once");
  EXPECT_EQ(defects[1].faces, (std::vector<Index>{0, 3}));
  EXPECT_EQ(defects[1].value, 2.0);
  EXPECT_EQ(defects[2].faces, (std::vector<Index>{1, 2}));
}

TEST(FindCorrupt, EveryTornLineIsOneDefectWithoutAPlace) {
  Soup soup = shapes::tetrahedron();
  soup.torn_lines = {3, 12};
  const DefectList defects = find_corrupt(soup);
  ASSERT_EQ(defects.size(), 2U);
  EXPECT_EQ(defects[0].detail, "line 3 is the remains of a torn record");
  EXPECT_EQ(defects[1].detail, "line 12 is the remains of a torn record");
  EXPECT_TRUE(defects[0].positions.empty());
}

TEST(FindCorrupt, EveryPositionThatIsNotFiniteIsOneDefectThatCannotBeMended) {
  Soup soup = shapes::grid(100, 100);
  soup.positions[9000].y() = kInfinity;
  soup.positions[17].z() = std::numeric_limits<double>::quiet_NaN();
  const DefectList defects = find_corrupt(soup);
  ASSERT_EQ(defects.size(), 2U);
  EXPECT_EQ(defects[0].vertices, std::vector<Index>{17});
  EXPECT_EQ(defects[1].vertices, std::vector<Index>{9000});
  EXPECT_FALSE(defects[0].fixable);
  EXPECT_TRUE(defects[0].positions.empty());
}

}  // namespace
}  // namespace meshalyzer
