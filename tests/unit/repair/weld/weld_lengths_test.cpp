#include "meshalyzer/repair/weld/internal/weld_lengths.h"

#include "meshalyzer/base/sort_unique.h"
#include "unit/repair/weld/weld_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::size_t kSmall = 12;
constexpr std::size_t kLarge = 1'000'000;

TEST(WeldSteps, FirstOneEndsAtTheShortestLength) {
  const WeldSteps steps(0.01, kSmall);
  EXPECT_EQ(steps.end_of(1e-9), 0.01);
  EXPECT_EQ(steps.end_of(0.01), 0.01);
}

TEST(WeldSteps, SmallMeshesHaveFourInEachPowerOfTwo) {
  const WeldSteps steps(0.01, kSmall);
  EXPECT_EQ(steps.end_of(0.5), 0.5);
  EXPECT_DOUBLE_EQ(steps.end_of(0.50001), std::exp2(-0.75));
  EXPECT_DOUBLE_EQ(steps.end_of(0.7), std::exp2(-0.5));
  EXPECT_DOUBLE_EQ(steps.end_of(0.8), std::exp2(-0.25));
  EXPECT_EQ(steps.end_of(0.9), 1.0);
  EXPECT_DOUBLE_EQ(steps.end_of(1.1), std::exp2(0.25));
}

TEST(WeldSteps, LargeMeshesHaveOneInEachPowerOfTwo) {
  const WeldSteps steps(0.0, kLarge);
  EXPECT_EQ(steps.end_of(0.50001), 1.0);
  EXPECT_EQ(steps.end_of(3.0), 4.0);
  EXPECT_EQ(steps.end_of(0.0), 0.0);
}

/// The border edges of two triangles that are 0.01 apart, and of two others, far away, that are
/// 0.0101 apart. Both distances are in the step from 0.00929... to 0.01105...
class WeldDistancesOfTwoGaps : public testing::Test {
 protected:
  WeldDistancesOfTwoGaps()
      : soup_(shapes::merged(two_triangles_apart(0.01),
                             shapes::translated(two_triangles_apart(0.0101), Vec3(9, 0, 0)))),
        mesh_(soup_),
        edges_(find_weld_edges(mesh_)),
        distances_(soup_.positions, edges_) {}

  /// Returns the faces of these edges, each once.
  [[nodiscard]] std::vector<Index> faces_of(const std::vector<Index>& edges) const {
    std::vector<Index> faces;
    for (const Index e : edges) faces.push_back(edges_[e].face);
    sort_unique(faces);
    return faces;
  }

  Soup soup_;
  PreparedMesh mesh_;
  std::vector<WeldEdge> edges_;
  WeldDistances distances_;
  WeldSteps steps_{1e-8, kSmall};
  double end_ = std::exp2(-6.5);
};

TEST_F(WeldDistancesOfTwoGaps, NextStepIsThatOfTheNextDistance) {
  const std::optional<double> next = distances_.next_step(steps_, 0.0, 0.1);
  ASSERT_TRUE(next);
  EXPECT_DOUBLE_EQ(*next, end_);
  // Sides of the triangles are 1 long, so that other distances are.
  EXPECT_EQ(distances_.next_step(steps_, *next, 0.1), std::nullopt);
  EXPECT_EQ(distances_.next_step(steps_, 0.0, 0.009), std::nullopt);
}

TEST_F(WeldDistancesOfTwoGaps, FirstStepIsThatOfTheseEdges) {
  const std::optional<double> first = distances_.first_step(distances_.all_edges(), steps_, 0.1);
  ASSERT_TRUE(first);
  EXPECT_DOUBLE_EQ(*first, end_);
  EXPECT_EQ(distances_.first_step({}, steps_, 0.1), std::nullopt);
}

TEST_F(WeldDistancesOfTwoGaps, EdgesWithADistanceBetweenAreLeftOut) {
  EXPECT_EQ(faces_of(distances_.edges_without_distance(0.011, end_)),
            (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(faces_of(distances_.edges_without_distance(0.01, end_)), (std::vector<Index>{0, 1}));
  EXPECT_EQ(faces_of(distances_.edges_without_distance(0.0099, end_)), std::vector<Index>());
}

}  // namespace
}  // namespace meshalyzer
