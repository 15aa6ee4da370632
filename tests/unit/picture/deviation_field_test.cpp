#include "meshalyzer/picture/deviation_field.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace meshalyzer {
namespace {

/// A cube of edge 1 in the middle of one of edge 2: each vertex of the inner one is half an edge
/// below three faces of the outer one, whose vertices are as far from those of the inner one along
/// each axis.
const Soup kInner = shapes::cube(1, {0.5, 0.5, 0.5});
const Soup kOuter = shapes::cube(2);

std::vector<double> deviations(const Soup& soup, const Soup& other) {
  const PreparedMesh mesh(other);
  return deviation_field(soup, mesh).values;
}

TEST(DeviationField, IsTheDistanceOfVerticesFromTheOtherSurface) {
  for (const double d : deviations(kInner, kOuter)) EXPECT_DOUBLE_EQ(d, 0.5);
  for (const double d : deviations(kOuter, kInner)) {
    EXPECT_DOUBLE_EQ(d, 0.5 * std::numbers::sqrt3);
  }
}

TEST(DeviationField, IsZeroOnTheSameSurface) {
  // A tetrahedron with a vertex at one corner of the cube and three in the middle of its edges.
  const Soup inside = shapes::scaled(shapes::tetrahedron(), 0.5);
  for (const double d : deviations(inside, shapes::cube(1))) EXPECT_EQ(d, 0.0);
}

TEST(DeviationField, VertexThatNoFaceUsesHasNoValue) {
  Soup soup = kInner;
  soup.positions.emplace_back(9, 9, 9);
  const std::vector<double> values = deviations(soup, kOuter);
  EXPECT_TRUE(std::isnan(values.back()));
  EXPECT_EQ(std::count(values.begin(), values.end(), 0.5), 8);
}

TEST(DeviationField, ThereIsNoneFromAMeshWithoutFaces) {
  for (const double d : deviations(kInner, Soup{})) EXPECT_TRUE(std::isnan(d));
}

TEST(DeviationField, IsAFieldOfVerticesThatIsNotNegative) {
  const PreparedMesh mesh(kOuter);
  const Field field = deviation_field(kInner, mesh);
  EXPECT_EQ(field.name, FieldName::Deviation);
  EXPECT_EQ(field.place, FieldPlace::Vertices);
  EXPECT_EQ(field.kind, FieldKind::Magnitude);
}

}  // namespace
}  // namespace meshalyzer
