#include "meshalyzer/set/spatial_order.h"

#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

using Meetings = std::vector<std::vector<Index>>;

Box3 unit_box(const Vec3& low) {
  return {low, low + Vec3::Ones()};
}

/// A lattice cube of 2^levels cells a side, as a curve that goes through its eight octants one
/// after the other, x fastest, visits it.
void visit(const Vec3& corner, int levels, std::vector<Vec3>& cells) {
  if (levels == 0) {
    cells.push_back(corner);
    return;
  }
  const double half = std::ldexp(1.0, levels - 1);
  for (const double z : {0.0, half}) {
    for (const double y : {0.0, half}) {
      for (const double x : {0.0, half}) {
        visit(corner + Vec3(x, y, z), levels - 1, cells);
      }
    }
  }
}

TEST(OrderInSpace, LatticeIsVisitedOctantByOctant) {
  std::vector<Vec3> cells;
  visit({-3, 100, 7}, 4, cells);
  const std::vector<Index> place = shapes::permutation(cells.size(), 3);
  std::vector<Box3> boxes(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    boxes[place[i]] = unit_box(cells[i]);
  }
  EXPECT_EQ(order_in_space(boxes), place);
}

TEST(OrderInSpace, EmptyBoxesAreLeftOut) {
  const std::vector<Box3> boxes{Box3(), unit_box({9, 0, 0}), Box3(), unit_box({4, 0, 0}), Box3()};
  EXPECT_EQ(order_in_space(boxes), (std::vector<Index>{3, 1}));
  EXPECT_EQ(order_in_space(std::vector<Box3>(3)), std::vector<Index>{});
  EXPECT_EQ(order_in_space({}), std::vector<Index>{});
}

TEST(OrderInSpace, OneBoxIsAlone) {
  EXPECT_EQ(order_in_space(std::vector<Box3>{Box3(Vec3(1, 2, 3))}), std::vector<Index>{0});
}

TEST(OrderInSpace, EqualBoxesKeepTheOrderOfTheirNumbers) {
  const std::vector<Box3> boxes(5, unit_box({1, 2, 3}));
  EXPECT_EQ(order_in_space(boxes), (std::vector<Index>{0, 1, 2, 3, 4}));
}

TEST(OrderInSpace, LargestAndSmallestCoordinatesKeepTheirOrder) {
  for (const double size : {kMax, 1e300, 1.0, 1e-300, 64 * kTiny}) {
    std::vector<Box3> boxes;
    for (const double x : {1.0, -1.0, 0.5, 0.0, -0.5, 0.75}) {
      boxes.emplace_back(Vec3(x * size, size, -size));
    }
    EXPECT_EQ(order_in_space(boxes), (std::vector<Index>{1, 4, 3, 2, 5, 0})) << size;
  }
}

/// All pairs, straight from the definition.
Meetings all_pairs(const std::vector<Box3>& boxes) {
  Meetings meeting(boxes.size());
  for (Index a = 0; a < boxes.size(); ++a) {
    for (Index b = 0; b < boxes.size(); ++b) {
      const bool meets = (boxes[a].min().array() <= boxes[b].max().array()).all() &&
                         (boxes[b].min().array() <= boxes[a].max().array()).all();
      if (a != b && meets && !boxes[a].isEmpty() && !boxes[b].isEmpty()) {
        meeting[a].push_back(b);
      }
    }
  }
  return meeting;
}

std::size_t count(const Meetings& meetings) {
  std::size_t n = 0;
  for (const auto& others : meetings) {
    n += others.size();
  }
  return n;
}

/// Boxes with corners on a lattice, so that many only touch; some are flat, some a point, some
/// empty.
std::vector<Box3> random_boxes(std::size_t n, const std::array<Index, 3>& extent,
                               std::mt19937& random) {
  std::vector<Box3> boxes(n);
  for (Box3& box : boxes) {
    if (below(random, 20) == 0) {
      continue;
    }
    for (int corner = 0; corner < 2; ++corner) {
      Vec3 p;
      for (std::size_t k = 0; k < 3; ++k) {
        const double low = box.isEmpty() ? below(random, extent[k]) : box.min()[Eigen::Index(k)];
        p[static_cast<Eigen::Index>(k)] = low + (box.isEmpty() ? 0 : below(random, 4));
      }
      box.extend(p);
    }
  }
  return boxes;
}

TEST(FindMeetingBoxes, EqualsAllPairsWhicheverAxisPartsThem) {
  std::mt19937 random(7);
  for (const auto& extent : {std::array<Index, 3>{12, 12, 12}, std::array<Index, 3>{200, 3, 3},
                             std::array<Index, 3>{3, 200, 3}, std::array<Index, 3>{3, 3, 200},
                             std::array<Index, 3>{1, 1, 1}, std::array<Index, 3>{40, 1, 1}}) {
    const std::vector<Box3> boxes = random_boxes(150, extent, random);
    const Meetings expected = all_pairs(boxes);
    EXPECT_EQ(find_meeting_boxes(boxes), expected);
    EXPECT_GT(count(expected), 100U);
  }
}

TEST(FindMeetingBoxes, NoneAndOneMeetNothing) {
  EXPECT_EQ(find_meeting_boxes({}), Meetings());
  EXPECT_EQ(find_meeting_boxes(std::vector<Box3>{unit_box({0, 0, 0})}), Meetings(1));
  EXPECT_EQ(find_meeting_boxes(std::vector<Box3>(2)), Meetings(2));
}

TEST(FindMeetingBoxes, EqualBoxesAllMeet) {
  EXPECT_EQ(find_meeting_boxes(std::vector<Box3>(3, unit_box({5, 5, 5}))),
            (Meetings{{1, 2}, {0, 2}, {0, 1}}));
}

TEST(FindMeetingBoxes, LargestCoordinatesDoNotOverflow) {
  const Vec3 far = Vec3::Constant(kMax);
  const std::vector<Box3> boxes{{-far, far}, Box3(far), Box3(-far), {-far, Vec3::Zero()}};
  EXPECT_EQ(find_meeting_boxes(boxes), (Meetings{{1, 2, 3}, {0}, {0, 3}, {0, 2}}));
}

TEST(BoxDistance, IsThatOfTheirNearestCornersEdgesOrSides) {
  const Box3 box = unit_box({0, 0, 0});
  // 3^2 + 4^2 = 5^2, and with 12^2 13^2.
  EXPECT_EQ(distance(box, unit_box({4, 0.5, -0.5})), 3.0);
  EXPECT_EQ(distance(box, unit_box({4, -5, 0})), 5.0);
  EXPECT_EQ(distance(box, unit_box({4, -5, 13})), 13.0);
  EXPECT_EQ(distance(unit_box({4, -5, 13}), box), 13.0);
  EXPECT_EQ(distance(box, Box3(Vec3(0.5, 3, 0.5))), 2.0);
}

TEST(BoxDistance, IsNothingWhereTheyTouchOverlapOrContain) {
  const Box3 box = unit_box({0, 0, 0});
  for (const Box3& other :
       {unit_box({1, 1, 1}), unit_box({0.5, -0.5, 0}), box, Box3(Vec3::Constant(0.5)),
        Box3(Vec3::Constant(-9), Vec3::Constant(9))}) {
    EXPECT_EQ(distance(box, other), 0.0);
    EXPECT_EQ(distance(other, box), 0.0);
  }
}

TEST(BoxDistance, SquaresNeitherOverflowNorUnderflow) {
  const Box3 origin(Vec3::Zero());
  EXPECT_NEAR(distance(origin, Box3(Vec3::Constant(1e200))) / 1e200, std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(distance(origin, Box3(Vec3::Constant(1e-200))) / 1e-200, std::sqrt(3.0), 1e-15);
  EXPECT_EQ(distance(origin, Box3(Vec3(0, kTiny, 0))), kTiny);
  // The true distance is larger than any double.
  EXPECT_EQ(distance(Box3(Vec3(-kMax, 0, 0)), Box3(Vec3(kMax, 0, 0))),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace meshalyzer
