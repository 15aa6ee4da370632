#include "meshalyzer/spatial/box_tree.h"

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

constexpr double kMaxDouble = std::numeric_limits<double>::max();
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

TEST(BoxTreeOrder, LatticeIsVisitedOctantByOctant) {
  std::vector<Vec3> cells;
  visit({-3, 100, 7}, 4, cells);
  const std::vector<Index> place = shapes::permutation(cells.size(), 3);
  std::vector<Box3> boxes(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    boxes[place[i]] = unit_box(cells[i]);
  }
  EXPECT_EQ(BoxTree(boxes).order(), place);
}

TEST(BoxTreeOrder, EmptyBoxesAreLeftOut) {
  const std::vector<Box3> boxes{Box3(), unit_box({9, 0, 0}), Box3(), unit_box({4, 0, 0}), Box3()};
  EXPECT_EQ(BoxTree(boxes).order(), (std::vector<Index>{3, 1}));
  EXPECT_EQ(BoxTree(std::vector<Box3>(3)).order(), std::vector<Index>{});
  EXPECT_EQ(BoxTree({}).order(), std::vector<Index>{});
}

TEST(BoxTreeOrder, OneBoxIsAlone) {
  EXPECT_EQ(BoxTree(std::vector<Box3>{Box3(Vec3(1, 2, 3))}).order(), std::vector<Index>{0});
}

TEST(BoxTreeOrder, EqualBoxesKeepTheOrderOfTheirNumbers) {
  const std::vector<Box3> boxes(5, unit_box({1, 2, 3}));
  EXPECT_EQ(BoxTree(boxes).order(), (std::vector<Index>{0, 1, 2, 3, 4}));
}

TEST(BoxTreeOrder, LargestAndSmallestCoordinatesKeepTheirOrder) {
  for (const double size : {kMaxDouble, 1e300, 1.0, 1e-300, 64 * kTiny}) {
    std::vector<Box3> boxes;
    for (const double x : {1.0, -1.0, 0.5, 0.0, -0.5, 0.75}) {
      boxes.emplace_back(Vec3(x * size, size, -size));
    }
    EXPECT_EQ(BoxTree(boxes).order(), (std::vector<Index>{1, 4, 3, 2, 5, 0})) << size;
  }
}

/// Returns the answers of the tree for each box that is not empty, without the box itself.
Meetings meetings(const std::vector<Box3>& boxes) {
  const BoxTree tree(boxes);
  Meetings meeting(boxes.size());
  for (Index i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].isEmpty()) {
      meeting[i] = tree.meeting(boxes[i]);
      EXPECT_EQ(std::erase(meeting[i], i), 1U);
    }
  }
  return meeting;
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

TEST(BoxTreeMeeting, EqualsAllPairsHoweverTheyLie) {
  std::mt19937 random(7);
  for (const auto& extent : {std::array<Index, 3>{12, 12, 12}, std::array<Index, 3>{200, 3, 3},
                             std::array<Index, 3>{3, 200, 3}, std::array<Index, 3>{3, 3, 200},
                             std::array<Index, 3>{1, 1, 1}, std::array<Index, 3>{40, 1, 1}}) {
    const std::vector<Box3> boxes = random_boxes(150, extent, random);
    const Meetings expected = all_pairs(boxes);
    EXPECT_EQ(meetings(boxes), expected);
    EXPECT_GT(count(expected), 100U);
  }
}

TEST(BoxTreeMeetsAny, EqualsWhetherSomethingIsMet) {
  std::mt19937 random(8);
  std::size_t n_met = 0;
  for (const Index extent : {3U, 12U, 60U}) {
    const BoxTree tree(random_boxes(150, {extent, extent, extent}, random));
    for (const Box3& box : random_boxes(150, {extent, extent, extent}, random)) {
      if (box.isEmpty()) continue;
      EXPECT_EQ(tree.meets_any(box), !tree.meeting(box).empty());
      n_met += tree.meets_any(box) ? 1 : 0;
    }
  }
  EXPECT_GT(n_met, 100U);
  EXPECT_LT(n_met, 400U);
  EXPECT_FALSE(BoxTree({}).meets_any(unit_box({0, 0, 0})));
}

TEST(BoxTreeMeeting, NoneAndOneMeetNothing) {
  EXPECT_EQ(meetings({}), Meetings());
  EXPECT_EQ(meetings(std::vector<Box3>{unit_box({0, 0, 0})}), Meetings(1));
  EXPECT_EQ(meetings(std::vector<Box3>(2)), Meetings(2));
}

TEST(BoxTreeMeeting, EqualBoxesAllMeet) {
  EXPECT_EQ(meetings(std::vector<Box3>(3, unit_box({5, 5, 5}))),
            (Meetings{{1, 2}, {0, 2}, {0, 1}}));
}

TEST(BoxTreeMeeting, LargestCoordinatesDoNotOverflow) {
  const Vec3 far = Vec3::Constant(kMaxDouble);
  const std::vector<Box3> boxes{{-far, far}, Box3(far), Box3(-far), {-far, Vec3::Zero()}};
  EXPECT_EQ(meetings(boxes), (Meetings{{1, 2, 3}, {0}, {0, 3}, {0, 2}}));
}

TEST(BoxTreeMeeting, BoxOfNobodyMayAskAndEmptyBoxesMeetNothing) {
  const std::vector<Box3> boxes{unit_box({0, 0, 0}), Box3(), unit_box({2, 0, 0})};
  EXPECT_EQ(BoxTree(boxes).meeting(Box3(Vec3(2.5, 0.5, 1))), std::vector<Index>{2});
  EXPECT_EQ(BoxTree(boxes).meeting(Box3()), std::vector<Index>{});
  EXPECT_EQ(BoxTree({}).meeting(unit_box({0, 0, 0})), std::vector<Index>{});
}

TEST(BoxTreeMeeting, InfiniteBoxesMeetAllOnTheirSide) {
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  const Vec3 far = Vec3::Constant(kEnd);
  const std::vector<Box3> boxes{
      {-far, far}, unit_box({5, 5, 5}), {-far, Vec3::Zero()}, unit_box({-5, -5, -5})};
  EXPECT_EQ(meetings(boxes), (Meetings{{1, 2, 3}, {0}, {0, 3}, {0, 2}}));
}

}  // namespace
}  // namespace meshalyzer
