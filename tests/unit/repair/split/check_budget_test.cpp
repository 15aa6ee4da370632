#include "meshalyzer/repair/split/internal/check_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

/// Returns the number of checks at all places together if each has one move and needs so many.
std::size_t checks_of(std::size_t n_places, std::size_t needed) {
  CheckBudget budget(n_places);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < n_places; ++i) {
    const std::size_t n = std::min(needed, budget.of_next_place());
    budget.spend(n);
    sum += n;
  }
  return sum;
}

TEST(CheckBudget, PlacesThatNeedFewChecksHaveThem) {
  EXPECT_EQ(checks_of(1'000'000, 500), 500'000'000U);
  EXPECT_EQ(checks_of(30, 8'000), 240'000U);
}

TEST(CheckBudget, AFewPlacesHaveManyMore) {
  EXPECT_EQ(checks_of(1, 1'000'000), 300'512U);
  CheckBudget budget(1'000);
  budget.spend(200'000);
  EXPECT_EQ(budget.of_next_place(), 8'192U + 300'000U - (200'000U - 8'192U));
  budget.spend(budget.of_next_place());
  EXPECT_EQ(budget.of_next_place(), 8'192U);
}

TEST(CheckBudget, ManyPlacesTogetherHaveAMeanNumber) {
  EXPECT_EQ(checks_of(10'000, 8'000), 300'000U + 512U * 10'000U);
  EXPECT_EQ(checks_of(10'000, 1'000'000), 300'000U + 512U * 10'000U);
}

TEST(CheckBudget, PlacesOfSeveralMovesHaveMore) {
  CheckBudget budget(7U * 1'000U);
  for (std::size_t i = 0; i < 1'000; ++i) {
    EXPECT_GE(budget.of_next_place(), 3'500U);
    budget.spend(3'500);
  }
}

}  // namespace
}  // namespace meshalyzer
