#include "meshalyzer/base/select_nth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

using Numbers = std::vector<std::uint64_t>;

std::uint64_t itself(std::uint64_t number) {
  return number;
}

Numbers random_numbers(std::size_t n, std::uint64_t largest) {
  std::mt19937_64 random(n + largest);
  std::uniform_int_distribution<std::uint64_t> number(0, largest);
  Numbers numbers(n);
  std::generate(numbers.begin(), numbers.end(), [&] { return number(random); });
  return numbers;
}

/// Tells whether the nth number is where sorting would put it, none after it is less, and none is
/// lost.
void expect_selected(const Numbers& numbers, std::size_t nth) {
  Numbers sorted = numbers;
  std::sort(sorted.begin(), sorted.end());
  Numbers selected = numbers;
  select_nth(std::span(selected), nth, itself);
  EXPECT_EQ(selected[nth], sorted[nth]);
  const auto middle = selected.begin() + static_cast<std::ptrdiff_t>(nth);
  EXPECT_TRUE(std::all_of(selected.begin(), middle, [&](auto x) { return x <= *middle; }));
  EXPECT_TRUE(std::all_of(middle, selected.end(), [&](auto x) { return x >= *middle; }));
  std::sort(selected.begin(), selected.end());
  EXPECT_EQ(selected, sorted);
}

TEST(SelectNth, AnyOfManySizesAndPlaces) {
  for (const std::size_t n : {1U, 2U, 7U, 16U, 17U, 40U, 127U, 500U, 5000U, 40000U}) {
    const Numbers numbers = random_numbers(n, ~std::uint64_t{0});
    for (const std::size_t nth : {std::size_t{0}, n / 3, n / 2, n - 1}) {
      SCOPED_TRACE(n);
      expect_selected(numbers, nth);
    }
  }
}

TEST(SelectNth, NumbersOfWhichManyAreEqual) {
  for (const std::uint64_t largest : {0U, 1U, 3U, 40U}) {
    SCOPED_TRACE(largest);
    expect_selected(random_numbers(20000, largest), 10000);
    expect_selected(random_numbers(20000, largest), 19999);
  }
}

TEST(SelectNth, SortedAndReversedNumbers) {
  Numbers numbers(30000);
  std::iota(numbers.begin(), numbers.end(), 0U);
  expect_selected(numbers, 15000);
  std::reverse(numbers.begin(), numbers.end());
  expect_selected(numbers, 15000);
}

TEST(SelectNth, BadPivotsInEachRoundStillEndIt) {
  // Pivots are taken from places that are multiples of n / size; all of them are the smallest
  // numbers at first, and again among what is left, so that each round takes away very few.
  Numbers numbers(16000, 1000);
  std::iota(numbers.begin(), numbers.end(), 100000U);
  for (std::size_t round = 0, rest = 16000; round < 40; ++round, rest -= 31) {
    for (std::size_t i = 0; i < 31; ++i) {
      numbers[16000 - rest + i * (rest / 31)] = 31 * round + i;
    }
  }
  expect_selected(numbers, 8000);
}

TEST(OrderedBits, AreOrderedAsTheNumbersAre) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> ascending{-infinity, -1e300, -1.0, -5e-324, -0.0,    0.0,
                                      5e-324,    1.0,    2.0,  1e300,   infinity};
  for (std::size_t i = 1; i < ascending.size(); ++i) {
    EXPECT_LT(ordered_bits(ascending[i - 1]), ordered_bits(ascending[i])) << ascending[i];
    const auto below = static_cast<float>(ascending[i - 1]);
    const auto above = static_cast<float>(ascending[i]);
    if (below < above) {
      EXPECT_LT(ordered_bits(below), ordered_bits(above)) << ascending[i];
    }
  }
}

}  // namespace
}  // namespace meshalyzer
