#include "meshalyzer/defects/finders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

TEST(FindNumbering, OneToNIsRight) {
  Soup soup = shapes::tetrahedron();
  EXPECT_TRUE(find_numbering(soup).empty());
  soup.vertex_ids.named = {1, 2, 3, 4};
  EXPECT_TRUE(find_numbering(soup).empty());
  EXPECT_TRUE(find_numbering({}).empty());
}

TEST(FindNumbering, FormatsThatNumberSilentlyAreRight) {
  Soup soup = shapes::tetrahedron();
  soup.format = Format::Off;
  soup.vertex_ids.first = 0;
  soup.face_ids.first = 0;
  EXPECT_TRUE(find_numbering(soup).empty());
}

TEST(FindNumbering, FirstWrongIdNamesTheOneDefectOfTheVertices) {
  Soup soup = shapes::tetrahedron();
  soup.vertex_ids.named = {1, 2, 4, 3};
  const DefectList defects = find_numbering(soup);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].code, DefectCode::Numbering);
  EXPECT_EQ(defects[0].severity, Severity::Warning);
  EXPECT_EQ(defects[0].vertices, std::vector<Index>{2});
  EXPECT_TRUE(defects[0].faces.empty());
  EXPECT_EQ(defects[0].value, 4.0);
  EXPECT_EQ(defects[0].limit, 3.0);
  EXPECT_EQ(defects[0].positions, std::vector<Vec3>{soup.positions[2]});
}

TEST(FindNumbering, FacesAreADefectOfTheirOwn) {
  Soup soup = shapes::tetrahedron();
  soup.vertex_ids.first = 0;
  soup.face_ids.named = {1, 2, 3, 3};
  const DefectList defects = find_numbering(soup);
  ASSERT_EQ(defects.size(), 2U);
  EXPECT_EQ(defects[0].vertices, std::vector<Index>{0});
  EXPECT_EQ(defects[0].value, 0.0);
  EXPECT_EQ(defects[0].limit, 1.0);
  EXPECT_EQ(defects[1].faces, std::vector<Index>{3});
  EXPECT_EQ(defects[1].value, 3.0);
  EXPECT_EQ(defects[1].limit, 4.0);
  EXPECT_EQ(defects[1].positions.size(), 1U);
}

TEST(FindNumbering, FaceWithoutAnyVertexHasNoPlace) {
  Soup soup = shapes::make({}, {{kNoIndex, kNoIndex, kNoIndex}});
  soup.face_ids.first = 7;
  const DefectList defects = find_numbering(soup);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_TRUE(defects[0].positions.empty());
}

}  // namespace
}  // namespace meshalyzer
