#include "meshalyzer/topology/border.h"

#include "direct_evaluation.h"
#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<direct::Edge> border_of(const Soup& soup) {
  const CutMesh cut = build(soup);
  std::vector<direct::Edge> edges;
  for (const HalfedgeHandle h : find_border_edges(cut)) {
    EXPECT_TRUE(cut.mesh.face_handle(h).is_valid());
    edges.push_back(direct::edge_of(cut, h));
  }
  return edges;
}

TEST(FindBorderEdges, ClosedMeshHasNone) {
  EXPECT_TRUE(border_of(shapes::cube()).empty());
  EXPECT_TRUE(border_of(Soup{}).empty());
}

TEST(FindBorderEdges, SingleFaceHasItsSidesInOrder) {
  const Soup soup = shapes::make(std::vector<Vec3>(3, Vec3::Zero()), {{2, 1, 0}});
  EXPECT_EQ(border_of(soup), (std::vector<direct::Edge>{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(FindBorderEdges, CutsOfClosedSurfacesAreNoBorders) {
  EXPECT_TRUE(border_of(shapes::projective_plane()).empty());
  EXPECT_TRUE(border_of(shapes::klein_bottle(5, 4)).empty());
  EXPECT_TRUE(border_of(shapes::two_tetrahedra_sharing_edge()).empty());
  EXPECT_TRUE(border_of(shapes::two_tetrahedra_sharing_face()).empty());
  EXPECT_TRUE(border_of(shapes::flipped(shapes::cube(), std::array<Index, 2>{0, 7})).empty());
}

TEST(FindBorderEdges, AxisOfAFanIsNone) {
  EXPECT_EQ(border_of(shapes::fan_of_three()),
            (std::vector<direct::Edge>{{0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}}));
}

TEST(FindBorderEdges, AgreesWithDirectEvaluationOnRandomSoups) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Soup soup = direct::random_soup(seed, 1 + seed % 24);
    const std::set<direct::Edge> expected = direct::edges_with(direct::complex_of(soup), 1);
    EXPECT_EQ(border_of(soup), std::vector<direct::Edge>(expected.begin(), expected.end()));
  }
}

}  // namespace
}  // namespace meshalyzer
