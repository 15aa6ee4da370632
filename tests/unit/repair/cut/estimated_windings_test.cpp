#include "meshalyzer/repair/cut/internal/estimated_windings.h"

#include "meshalyzer/arrangement/windings.h"
#include "support/arranged_mesh.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Makes slabs across each of the three axes, which all cross those across the others.
Soup crossing_slabs(int n_of_axis) {
  Soup slabs;
  for (int axis = 0; axis < 3; ++axis) {
    // No end of a slab lies in the plane of another's.
    const double beyond = 1.0 + 0.125 * axis;
    for (int i = 0; i < n_of_axis; ++i) {
      Vec3 low = Vec3::Constant(-beyond);
      Vec3 high = Vec3::Constant(2.0 * n_of_axis + beyond);
      low[axis] = 2.0 * i;
      high[axis] = 2.0 * i + 1.0;
      slabs = shapes::merged(std::move(slabs), shapes::box(low, high));
    }
  }
  return slabs;
}

/// A soup, cut, with the estimates for its cells.
struct Estimated : test::ArrangedMesh {
  explicit Estimated(Soup mesh)
      : ArrangedMesh(std::move(mesh)),
        windings(estimate_windings(arranged, std::vector<std::uint8_t>(cells.n_components, 1),
                                   [] { return false; })) {}

  [[nodiscard]] std::size_t n_patches() const {
    std::set<std::array<Index, 2>> patches;
    for (Index i = 0; i < arrangement.pieces.size(); ++i) {
      patches.insert({cells.front(i), cells.behind(i)});
    }
    return patches.size();
  }

  EstimatedWindings windings;
};

/// Expects the winding numbers that exact rays and sums give.
void expect_true_windings(int n_of_axis) {
  const Estimated estimated(crossing_slabs(n_of_axis));
  const Windings truth = find_windings(estimated.arranged, std::vector<std::uint8_t>(1, 1));
  ASSERT_EQ(estimated.cells.n_components, 1U);
  EXPECT_EQ(estimated.windings.bounds_solid, std::vector<std::uint8_t>{1});
  for (std::size_t cell = 0; cell < estimated.cells.count && !testing::Test::HasFailure(); ++cell) {
    EXPECT_NEAR(estimated.windings.of_cell[cell], truth.own[cell], 0.1);
  }
}

TEST(EstimateWindings, CellsOfAFewCrossingSlabsHaveTheirExactWindingNumbers) {
  expect_true_windings(2);
}

TEST(EstimateWindings, CellsOfThousandsOfPatchesHaveTheirExactWindingNumbers) {
  EXPECT_GT(Estimated(crossing_slabs(6)).n_patches(), 4096U);
  expect_true_windings(6);
}

TEST(EstimateWindings, SheetsThatCrossBoundNoSolid) {
  const Soup sheet = shapes::grid(2, 2);
  Soup upright = sheet;
  for (Vec3& p : upright.positions) p = {p.x(), 0.7, p.y() - 0.6};
  const Soup both = shapes::merged(sheet, upright);
  EXPECT_EQ(Estimated(both).windings.bounds_solid, std::vector<std::uint8_t>{0});
}

}  // namespace
}  // namespace meshalyzer
