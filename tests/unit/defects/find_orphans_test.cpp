#include "meshalyzer/defects/finders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

std::vector<Index> orphans_in(const Soup& soup) {
  std::vector<Index> vertices;
  for (const Defect& defect : find_orphans(soup)) {
    EXPECT_EQ(defect.code, DefectCode::OrphanVertex);
    EXPECT_EQ(defect.severity, Severity::Warning);
    EXPECT_EQ(defect.positions, std::vector<Vec3>{soup.positions[defect.vertices.at(0)]});
    vertices.push_back(defect.vertices[0]);
  }
  return vertices;
}

TEST(FindOrphans, UsedVerticesAreNone) {
  EXPECT_TRUE(orphans_in({}).empty());
  EXPECT_TRUE(orphans_in(shapes::cube()).empty());
}

TEST(FindOrphans, VerticesWithoutAFaceAre) {
  EXPECT_EQ(orphans_in(shapes::make(std::vector<Vec3>(5, Vec3(1, 2, 3)), {{1, 3, 2}})),
            (std::vector<Index>{0, 4}));
}

TEST(FindOrphans, VertexOfAFaceThatIsNotInTheComplexIsNone) {
  EXPECT_EQ(orphans_in(shapes::make(std::vector<Vec3>(4, Vec3(1, 2, 3)),
                                    {{1, 1, 0}, {3, kNoIndex, kNoIndex}})),
            std::vector<Index>{2});
}

TEST(FindOrphans, RecordThatRepeatsAnIdIsNone) {
  Soup soup = shapes::tetrahedron();
  soup.positions.emplace_back(7, 7, 7);
  soup.positions.emplace_back(8, 8, 8);
  soup.vertex_ids.named = {1, 2, 3, 4, 2, 9};
  EXPECT_EQ(orphans_in(soup), std::vector<Index>{5});
}

}  // namespace
}  // namespace meshalyzer
