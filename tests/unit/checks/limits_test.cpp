#include "meshalyzer/checks/limits.h"

#include "meshalyzer/base/error.h"
#include "support/constants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

std::vector<LimitViolation> beyond(const Soup& soup, LimitKind kind, double limit) {
  return find_beyond_limit(PreparedMesh(soup), kind, limit);
}

TEST(LimitTable, EveryLimitIsFoundByItsName) {
  for (const LimitInfo& info : limit_table()) EXPECT_EQ(limit_kind(info.name), info.kind);
  EXPECT_EQ(limit_kind("max-weight"), std::nullopt);
}

// Every face of the cube is half a square: angles of 45 and 90 degrees, aspect ratio 2, edges of
// length 1 and sqrt(2).
TEST(FindBeyondLimit, ValuesAtTheLimitPass) {
  const Soup cube = shapes::cube();
  EXPECT_TRUE(beyond(cube, LimitKind::MinEdgeLength, 1.0).empty());
  EXPECT_TRUE(beyond(cube, LimitKind::MinFaces, 12).empty());
  EXPECT_TRUE(beyond(cube, LimitKind::MaxFaces, 12).empty());
  EXPECT_TRUE(beyond(cube, LimitKind::MaxEdgeAngle, 270).empty());
  EXPECT_TRUE(beyond(cube, LimitKind::MaxComponents, 1).empty());
}

TEST(FindBeyondLimit, FacesAreNamedWithTheirValue) {
  const std::vector<LimitViolation> found = beyond(shapes::cube(), LimitKind::MaxAspectRatio, 1.9);
  ASSERT_EQ(found.size(), 12U);
  EXPECT_EQ(found[3].faces, (std::vector<Index>{3}));
  EXPECT_DOUBLE_EQ(found[3].value, 2.0);
  EXPECT_EQ(beyond(shapes::cube(), LimitKind::MinCornerAngle, 46).size(), 12U);
  EXPECT_TRUE(beyond(shapes::cube(), LimitKind::MinCornerAngle, 44).empty());
}

TEST(FindBeyondLimit, EdgesAreNamedByTheirEndsWithTheirFaces) {
  // The six diagonals.
  const std::vector<LimitViolation> found = beyond(shapes::cube(), LimitKind::MaxEdgeLength, 1.1);
  ASSERT_EQ(found.size(), 6U);
  for (const LimitViolation& edge : found) {
    EXPECT_EQ(edge.vertices.size(), 2U);
    EXPECT_EQ(edge.faces.size(), 2U);
    EXPECT_LT(edge.vertices[0], edge.vertices[1]);
  }
  // The other twelve.
  EXPECT_EQ(beyond(shapes::cube(), LimitKind::MaxEdgeAngle, 200).size(), 12U);
  EXPECT_EQ(beyond(shapes::cube(), LimitKind::MinEdgeAngle, 200).size(), 6U);
}

TEST(FindBeyondLimit, WholeMeshIsNamedByNoElement) {
  const std::vector<LimitViolation> found = beyond(shapes::cube(), LimitKind::MaxFaces, 11);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].faces.empty());
  EXPECT_EQ(found[0].value, 12.0);
}

TEST(FindBeyondLimit, LimitThatIsNotANumberIsRefused) {
  for (const LimitInfo& info : limit_table()) {
    EXPECT_THROW(static_cast<void>(beyond(shapes::cube(), info.kind, kNaN)), InvalidArgument)
        << info.name;
  }
}

TEST(FindBeyondLimit, MeshWithAPositionThatIsNotFiniteIsRefused) {
  Soup soup = shapes::cube();
  soup.positions[5].y() = kNaN;
  for (const LimitInfo& info : limit_table()) {
    EXPECT_THROW(static_cast<void>(beyond(soup, info.kind, 1.0)), InvalidArgument) << info.name;
  }
}

}  // namespace
}  // namespace meshalyzer
