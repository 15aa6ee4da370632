#include "meshalyzer/mesh/repeated_ids.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<Index> repeated(std::vector<std::int32_t> ids) {
  return find_repeated_ids({.first = 1, .named = std::move(ids)});
}

TEST(FindRepeatedIds, DifferentIdsInAnyOrderAreNotRepeated) {
  EXPECT_TRUE(repeated({}).empty());
  EXPECT_TRUE(repeated({1, 2, 3}).empty());
  EXPECT_TRUE(repeated({7, -2, 3}).empty());
  EXPECT_TRUE(find_repeated_ids({.first = 0, .named = {}}).empty());
}

TEST(FindRepeatedIds, AllButTheFirstRecordOfAnIdAre) {
  EXPECT_EQ(repeated({5, 5}), (std::vector<Index>{1}));
  EXPECT_EQ(repeated({9, 5, 9, 1, 5, 9}), (std::vector<Index>{2, 4, 5}));
}

TEST(FindRepeatedIds, IdsOfTheWholeRangeKeepApart) {
  constexpr auto kLow = std::numeric_limits<std::int32_t>::min();
  constexpr auto kHigh = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(repeated({kHigh, kLow, -1, 0, kHigh, kLow}), (std::vector<Index>{4, 5}));
}

TEST(FindRepeatedIds, AgreesWithASetOnRandomIds) {
  std::mt19937 random(20270114);
  for (std::uint32_t round = 0; round < 200; ++round) {
    std::vector<std::int32_t> ids(round);
    for (std::int32_t& id : ids) id = static_cast<std::int32_t>(random() % 100) - 50;
    std::vector<Index> expected;
    std::set<std::int32_t> met;
    for (Index i = 0; i < round; ++i) {
      if (!met.insert(ids[i]).second) expected.push_back(i);
    }
    EXPECT_EQ(repeated(ids), expected);
  }
}

}  // namespace
}  // namespace meshalyzer
