#include "meshalyzer/topology/manifold.h"

#include "direct_evaluation.h"
#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace meshalyzer {
namespace {

TEST(FindPinchedVertices, ManifoldHasNone) {
  EXPECT_TRUE(find_pinched_vertices(build(shapes::genus_block(1))).empty());
  EXPECT_TRUE(find_pinched_vertices(build(shapes::moebius_strip(5))).empty());
  EXPECT_TRUE(find_pinched_vertices(build(Soup{})).empty());
}

TEST(FindPinchedVertices, CommonVertexOfTwoTetrahedraIsPinched) {
  EXPECT_EQ(find_pinched_vertices(build(shapes::two_tetrahedra_sharing_vertex())),
            std::vector<Index>{0});
}

TEST(FindPinchedVertices, EndsOfNonManifoldEdgesAreNone) {
  EXPECT_TRUE(find_pinched_vertices(build(shapes::two_tetrahedra_sharing_edge())).empty());
  EXPECT_TRUE(find_pinched_vertices(build(shapes::fan_of_three())).empty());
}

TEST(FindPinchedVertices, FlippedFaceDoesNotPinch) {
  const std::array<Index, 1> face{4};
  EXPECT_TRUE(find_pinched_vertices(build(shapes::flipped(shapes::cube(), face))).empty());
}

TEST(FindPinchedVertices, AgreeWithDirectEvaluationOnRandomSoups) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Soup soup = direct::random_soup(seed, 1 + seed % 16);
    EXPECT_EQ(find_pinched_vertices(build(soup)),
              direct::pinched_vertices(direct::complex_of(soup)));
  }
}

}  // namespace
}  // namespace meshalyzer
