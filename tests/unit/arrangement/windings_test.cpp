#include "meshalyzer/arrangement/windings.h"

#include "support/arranged_mesh.h"
#include "support/effort.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace meshalyzer {
namespace {

/// A soup, cut, with its cells and their winding numbers.
struct Cut : test::ArrangedMesh {
  explicit Cut(Soup mesh)
      : ArrangedMesh(std::move(mesh)),
        windings(find_windings(arranged, std::vector<std::uint8_t>(cells.n_components, 1))) {}

  /// The winding number of a cell by all components.
  [[nodiscard]] int winding(std::size_t piece, Index cell) const {
    return windings.own[cell] + windings.others[cells.component_of[piece]];
  }

  /// The volume of all space with at least this winding number, by the divergence theorem.
  [[nodiscard]] double volume(int winding_at_least) const {
    double six_times = 0.0;
    for (std::size_t i = 0; i < arrangement.pieces.size(); ++i) {
      const int front = winding(i, cells.front(i)) >= winding_at_least ? 1 : 0;
      const int behind = winding(i, cells.behind(i)) >= winding_at_least ? 1 : 0;
      const Triangle& t = arrangement.pieces[i];
      const std::vector<Vec3>& at = arrangement.positions;
      six_times += (behind - front) * at[t[0]].dot(at[t[1]].cross(at[t[2]]));
    }
    return six_times / 6.0;
  }

  Windings windings;
};

TEST(FindWindings, CubesThatCrossAreOnceAroundTheirUnionAndTwiceAroundWhatIsCommon) {
  const Cut cut(shapes::merged(shapes::cube(2), shapes::cube(2, {1, 1, 1})));
  EXPECT_EQ(cut.cells.n_components, 1U);
  // Outside, each cube without the other, and what is common.
  EXPECT_EQ(cut.cells.count, 4U);
  EXPECT_EQ(cut.cells.is_closed, std::vector<std::uint8_t>{1});
  EXPECT_EQ(cut.volume(1), 15.0);
  EXPECT_EQ(cut.volume(2), 1.0);
  EXPECT_EQ(cut.volume(3), 0.0);
}

TEST(FindWindings, CavityIsNoneAroundAndItsSurroundingsOnce) {
  const Cut cut(shapes::nested_cubes(shapes::InnerShell::Cavity));
  EXPECT_EQ(cut.cells.n_components, 2U);
  EXPECT_EQ(cut.windings.others, (std::vector<int>{0, 1}));
  EXPECT_EQ(cut.windings.own[cut.cells.behind(0)], 1);
  // The wall of the cavity points into it.
  EXPECT_EQ(cut.windings.own[cut.cells.front(12)], -1);
  EXPECT_EQ(cut.windings.own[cut.cells.behind(12)], 0);
}

TEST(FindWindings, FaceTurnedOverOpensTheChain) {
  const std::vector<Index> turned{3};
  const Cut cut(shapes::flipped(shapes::cube(), turned));
  EXPECT_EQ(cut.cells.is_closed, std::vector<std::uint8_t>{0});
}

TEST(FindWindings, HoleJoinsNoCells) {
  const Cut cut(shapes::open_cube());
  EXPECT_EQ(cut.cells.count, 2U);
  EXPECT_EQ(cut.cells.is_closed, std::vector<std::uint8_t>{0});
}

TEST(FindWindings, ThreePlanesThroughOnePointAreToldApartRoundTheirEdges) {
  // Three slabs of thickness 1 through the same unit cube, each 3 x 3 x 1.
  const Cut cut(shapes::merged(
      shapes::merged(shapes::box({0, -1, -1}, {1, 2, 2}), shapes::box({-1, 0, -1}, {2, 1, 2})),
      shapes::box({-1, -1, 0}, {2, 2, 1})));
  // Inclusion and exclusion: 3 * 9 - 3 * 3 + 1.
  EXPECT_NEAR(cut.volume(1), 19.0, 1e-12);
  // Three bars of volume 3 through the cube.
  EXPECT_NEAR(cut.volume(2), 7.0, 1e-12);
  EXPECT_NEAR(cut.volume(3), 1.0, 1e-12);
}

/// The 27 ways in which an interval of length 1, 2 or 3 can lie to [3, 6], on a grid.
std::pair<double, double> interval(std::size_t i) {
  const auto low = static_cast<double>(i % 9);
  return {low, low + static_cast<double>(1 + i / 9)};
}

TEST(FindWindings, TwoBoxesInAllIntegerRelationsHaveTheVolumesOfUnionAndIntersection) {
  // All slopes are quotients of 1, 2 and 3: on this grid all points are whole numbers.
  constexpr double kGrid = 5040;
  constexpr std::size_t kShare = 41;
  for (std::size_t i = 0; i < 27 * 27 * 27; i += kShare * test::one_of()) {
    const std::array<std::pair<double, double>, 3> other{interval(i % 27), interval(i / 27 % 27),
                                                         interval(i / 27 / 27)};
    Soup box = shapes::cube();
    double volume = 1.0;
    double common = 1.0;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto [low, high] = other[static_cast<std::size_t>(k)];
      for (Vec3& p : box.positions) p[k] = kGrid * (low + p[k] * (high - low));
      volume *= high - low;
      common *= std::max(0.0, std::min(high, 6.0) - std::max(low, 3.0));
    }
    const Cut cut(shapes::merged(shapes::cube(3 * kGrid, kGrid * Vec3(3, 3, 3)), box));
    const double cell = kGrid * kGrid * kGrid;
    ASSERT_EQ(cut.volume(1), (27.0 + volume - common) * cell) << i;
    ASSERT_EQ(cut.volume(2), common * cell) << i;
  }
}

}  // namespace
}  // namespace meshalyzer
