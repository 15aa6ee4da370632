#include "meshalyzer/set/nearby_objects.h"

#include "meshalyzer/set/box_distance.h"
#include "support/random_soups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

/// Boxes of side 1 on a lattice of a given width, so that many touch and many are equally far.
std::vector<Box3> lattice_boxes(std::size_t n, double width, std::mt19937& random) {
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 corner(below(random, 12), below(random, 12), below(random, 3));
    boxes.emplace_back(width * corner, width * (corner + Vec3::Ones()));
  }
  return boxes;
}

std::vector<Index> numbers_of(const std::vector<NearbyObjects::Candidate>& candidates) {
  std::vector<Index> numbers;
  for (const auto& candidate : candidates) {
    numbers.push_back(candidate.object);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// The others that are in one shell: at `low` or farther, and at `high` at most; both are far from
/// any distance that occurs.
std::vector<Index> in_shell(const std::vector<Box3>& boxes, Index object, double low, double high) {
  std::vector<Index> numbers;
  for (Index other = 0; other < boxes.size(); ++other) {
    const double d = distance(boxes[object], boxes[other]);
    if (other != object && low <= d && d <= high) {
      numbers.push_back(other);
    }
  }
  return numbers;
}

/// Reach is to the sides of the grown box, so its corners are farther: some come early.
bool is_subset(const std::vector<Index>& part, const std::vector<Index>& whole) {
  return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
}

TEST(NearbyObjects, EachIsGivenOnceAndNoneLaterThanItsDistance) {
  std::mt19937 random(5);
  for (const double width : {1.0, 1e-300, 1e300, 3.7}) {
    const std::vector<Box3> boxes = lattice_boxes(200, width, random);
    const BoxTree tree(boxes);
    for (Index object = 0; object < boxes.size(); object += 17) {
      NearbyObjects others(object, boxes, tree);
      std::vector<Index> given = numbers_of(others.within(0.0));
      EXPECT_EQ(given, in_shell(boxes, object, 0.0, 0.0));
      for (const double reach : {0.5, 1.5, 2.5, 20.0}) {
        const std::vector<Index> fresh = numbers_of(others.within(reach * width));
        EXPECT_LE(others.given_up_to(), reach * width);
        EXPECT_FALSE(std::any_of(fresh.begin(), fresh.end(), [&](Index other) {
          return std::binary_search(given.begin(), given.end(), other);
        }));
        given.insert(given.end(), fresh.begin(), fresh.end());
        std::sort(given.begin(), given.end());
        EXPECT_TRUE(is_subset(in_shell(boxes, object, 0.0, reach * width), given));
      }
      EXPECT_TRUE(others.all_given());
      EXPECT_EQ(given.size(), boxes.size() - 1);
    }
  }
}

TEST(NearbyObjects, NearestOfAShellComesFirst) {
  std::mt19937 random(6);
  const std::vector<Box3> boxes = lattice_boxes(60, 1.0, random);
  const BoxTree tree(boxes);
  NearbyObjects others(0, boxes, tree);
  const auto shell = others.within(std::numeric_limits<double>::infinity());
  ASSERT_EQ(shell.size(), 59U);
  for (std::size_t i = 0; i < shell.size(); ++i) {
    EXPECT_EQ(shell[i].distance, distance(boxes[0], boxes[shell[i].object]));
    EXPECT_LE(shell[i == 0 ? 0 : i - 1].distance, shell[i].distance);
  }
}

TEST(NearbyObjects, FarFromTheOriginNoneIsLostToRounding) {
  // At 1e15 coordinates are eighths apart: growing by 0.25 must yet reach a box 0.25 away.
  const Vec3 far = Vec3::Constant(1e15);
  const std::vector<Box3> boxes{{far, far + Vec3::Ones()},
                                {far + Vec3(1.25, 0, 0), far + Vec3(2, 1, 1)}};
  const BoxTree tree(boxes);
  NearbyObjects others(0, boxes, tree);
  static_cast<void>(others.within(0.25));
  EXPECT_TRUE(others.all_given());
}

TEST(NearbyObjects, AloneThereIsNothingToGive) {
  const std::vector<Box3> boxes{Box3(), Box3(Vec3(1, 2, 3))};
  const BoxTree tree(boxes);
  EXPECT_TRUE(NearbyObjects(1, boxes, tree).all_given());
}

}  // namespace
}  // namespace meshalyzer
