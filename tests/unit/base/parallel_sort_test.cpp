#include "meshalyzer/base/parallel_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

/// Pairs of numbers, many of them equal.
std::vector<std::array<int, 2>> random_pairs(std::size_t n) {
  std::mt19937 random(20261129);
  std::vector<std::array<int, 2>> pairs(n);
  for (auto& pair : pairs)
    pair = {static_cast<int>(random() % 100), static_cast<int>(random() % 100)};
  return pairs;
}

/// Few items are sorted by one thread, many by all.
constexpr std::array<std::size_t, 4> kLengths{0, 1, 1000, 10 * kChunkLength + 7};

TEST(ParallelSort, SortsAsTheStandardLibrary) {
  for (const std::size_t n : kLengths) {
    std::vector<std::array<int, 2>> expected = random_pairs(n);
    std::vector<std::array<int, 2>> pairs = expected;
    std::sort(expected.begin(), expected.end(), std::greater<>());
    parallel_sort(pairs, std::greater<>());
    EXPECT_EQ(pairs, expected) << n;
  }
}

TEST(ParallelSort, RepeatedItemsGo) {
  for (const std::size_t n : kLengths) {
    std::vector<std::array<int, 2>> pairs = random_pairs(n);
    std::vector<std::array<int, 2>> expected = pairs;
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    parallel_sort_unique(pairs);
    EXPECT_EQ(pairs, expected) << n;
  }
}

}  // namespace
}  // namespace meshalyzer
