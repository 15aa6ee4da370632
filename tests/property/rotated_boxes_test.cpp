#include "cell_model.h"
#include "meshalyzer/boolean/combine_solids.h"
#include "meshalyzer/repair/combine/mend_combined.h"
#include "meshalyzer/repair/combine/track_combined.h"
#include "support/boolean_results.h"
#include "support/effort.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

using test::rotated;
using test::verdict_on;
using test::volume_of;

/// The distance that repair may move the surface of boxes whose edges are whole numbers.
constexpr double kMaxDeviation = 1e-4;

/// Boxes of a grid, and the same ones turned together: walls that coincided, or were in one plane,
/// are some roundings apart then, and cross each other there.
struct RotatedBoxes {
  std::vector<CellModel::Box> boxes;
  std::vector<Soup> meshes;
};

RotatedBoxes rotated_boxes(std::uint32_t seed) {
  std::mt19937 random(seed);
  // Distributions of the standard library differ from platform to platform.
  const auto whole = [&random](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  const auto real = [&random] { return static_cast<double>(random()) / 4294967295.0 * 2.0 - 1.0; };
  RotatedBoxes all;
  const int n = whole(2, 9);
  const double angle = 3.0 * real();
  const double x = real();
  const double y = real();
  const Vec3 axis(x, y, real());
  for (int i = 0; i < n; ++i) {
    CellModel::Box box{};
    for (auto& [low, high] : box) {
      low = whole(0, 5);
      high = low + whole(1, 4);
    }
    all.boxes.push_back(box);
    all.meshes.push_back(rotated(box_mesh(box), angle, axis));
  }
  return all;
}

/// What `meshfixer` makes of several meshes and a rule.
Soup combined_and_mended(const std::vector<Soup>& meshes, const InsideRule& rule) {
  const Soup all = concatenate(meshes);
  CombineOptions options;
  options.max_deviation = kMaxDeviation;
  const CombinedSolid solid = combine_solids(operands_of(all, meshes), rule, options);
  return mend_combined(track_combined(all, solid), solid.outcome, false, options).mesh.soup;
}

TEST(RotatedBoxes, HaveTheVolumeOfTheirCellsUnderEveryRule) {
  constexpr std::uint32_t kSets = 100;
  test::Effort effort;
  for (std::uint32_t seed = 0; seed < kSets; ++seed) {
    if (!effort.runs_next()) continue;
    const RotatedBoxes set = rotated_boxes(seed);
    for (const InsideRule& rule : {union_rule(), intersection_rule(), difference_rule()}) {
      const double volume = CellModel(set.boxes, rule).volume();
      const Soup result = combined_and_mended(set.meshes, rule);
      if (result.triangles.empty()) {
        EXPECT_EQ(volume, 0.0) << seed;
        continue;
      }
      EXPECT_EQ(verdict_on(result), "good") << seed;
      // The surface of the boxes is below 1,000.
      EXPECT_NEAR(volume_of(result), volume, 1000 * kMaxDeviation) << seed;
    }
  }
}

}  // namespace
}  // namespace meshalyzer
