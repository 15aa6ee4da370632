#include "meshalyzer/base/statistics.h"

#include "meshalyzer/base/parallel.h"
#include "support/constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

/// 1, 2, ..., n in an order that is not theirs.
std::vector<double> shuffled_counting(std::size_t n) {
  std::vector<double> values(n);
  std::iota(values.begin(), values.end(), 1.0);
  std::shuffle(values.begin(), values.end(), std::mt19937_64(7));
  return values;
}

std::size_t counted(const Histogram& histogram) {
  return std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::size_t{0});
}

TEST(Summarize, CountingNumbersHaveTheirClosedForms) {
  const double n = 100001;
  std::vector<double> values = shuffled_counting(100001);
  const Statistics s = summarize(values);
  EXPECT_EQ(s.count, values.size());
  EXPECT_EQ(s.min, 1.0);
  EXPECT_EQ(s.max, n);
  EXPECT_DOUBLE_EQ(s.total, n * (n + 1) / 2);
  EXPECT_DOUBLE_EQ(s.mean, (n + 1) / 2);
  // The sum of squared deviations is n (n^2 - 1) / 12; divided by n - 1.
  EXPECT_DOUBLE_EQ(s.variance, n * (n + 1) / 12);
}

TEST(Summarize, MedianOfAnOddCountIsTheMiddleValue) {
  std::vector<double> values = {9, 1, 5, 4, 100};
  EXPECT_EQ(summarize(values).median, 5.0);
}

TEST(Summarize, MedianOfAnEvenCountIsTheMeanOfTheMiddleTwo) {
  std::vector<double> values = {9, 1, 5, 4};
  EXPECT_EQ(summarize(values).median, 4.5);
}

TEST(Summarize, MedianOfTheSmallestDoublesIsNotRoundedAway) {
  // Half of it is no double: halves added up would give 0.
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  std::vector<double> values = {kSmallest, kSmallest};
  EXPECT_EQ(summarize(values).median, kSmallest);
}

TEST(Summarize, ASingleValueHasNoVariance) {
  std::vector<double> values = {3.5};
  const Statistics s = summarize(values);
  EXPECT_EQ(s.count, 1U);
  EXPECT_EQ(s.min, 3.5);
  EXPECT_EQ(s.max, 3.5);
  EXPECT_EQ(s.mean, 3.5);
  EXPECT_EQ(s.median, 3.5);
  EXPECT_EQ(s.variance, 0.0);
  EXPECT_EQ(counted(s.histogram), 1U);
}

TEST(Summarize, EqualValuesHaveThatMeanExactly) {
  std::vector<double> values(1000, 0.1);
  const Statistics s = summarize(values);
  EXPECT_EQ(s.mean, 0.1);
  EXPECT_EQ(s.variance, 0.0);
}

TEST(Summarize, NoValuesGiveZeros) {
  const Statistics s = summarize({});
  EXPECT_EQ(s.count, 0U);
  EXPECT_EQ(s.total, 0.0);
  EXPECT_EQ(counted(s.histogram), 0U);
}

TEST(Summarize, InfinitiesAreCountedApart) {
  std::vector<double> values = {kInfinity, 1, 3, -kInfinity, kInfinity};
  const Statistics s = summarize(values);
  EXPECT_EQ(s.count, 2U);
  EXPECT_EQ(s.infinite, 3U);
  EXPECT_EQ(s.max, 3.0);
  EXPECT_EQ(s.mean, 2.0);
  EXPECT_EQ(s.variance, 2.0);  // (1 + 1) / (2 - 1)
}

TEST(Summarize, InfinitiesAloneLeaveNothingToSummarize) {
  std::vector<double> values = {kInfinity, kInfinity};
  const Statistics s = summarize(values);
  EXPECT_EQ(s.count, 0U);
  EXPECT_EQ(s.infinite, 2U);
}

TEST(Summarize, HistogramOfSixteenEvenStepsHasEqualBins) {
  // 0, 1, ..., 15 and 16: bins of width 1, the last with its upper edge too.
  std::vector<double> values(17);
  std::iota(values.begin(), values.end(), 0.0);
  const Histogram histogram = summarize(values).histogram;
  for (std::size_t i = 0; i < Histogram::kBins; ++i) {
    EXPECT_EQ(histogram.edges[i], static_cast<double>(i));
    EXPECT_EQ(histogram.counts[i], i + 1 == Histogram::kBins ? 2U : 1U);
  }
  EXPECT_EQ(histogram.edges.back(), 16.0);
}

TEST(Summarize, HistogramCountsEveryFiniteValueOnce) {
  std::vector<double> values = shuffled_counting(50000);
  values.push_back(kInfinity);
  EXPECT_EQ(counted(summarize(values).histogram), 50000U);
}

TEST(Summarize, EachValueIsInTheBinBetweenItsEdges) {
  // The values are the edges of the bins, and their neighbours, of ranges of any width.
  for (const double width : {5e-324, 1e-300, 1e-16, 0.3, 7.0, 1e300}) {
    std::vector<double> ends{0.1, 0.1 + width};
    const auto edges = summarize(ends).histogram.edges;
    std::vector<double> values;
    for (const double edge : edges) {
      for (const double value : {std::nextafter(edge, -1e308), edge, std::nextafter(edge, 1e308)}) {
        values.push_back(std::clamp(value, edges.front(), edges.back()));
      }
    }
    std::array<std::size_t, Histogram::kBins> expected{};
    for (const double value : values) {
      const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, value);
      ++expected[static_cast<std::size_t>(above - edges.begin()) - 1];
    }
    EXPECT_EQ(summarize(values).histogram.counts, expected) << width;
  }
}

TEST(Summarize, TheWidestRangeOfDoublesDoesNotOverflow) {
  constexpr double kMax = std::numeric_limits<double>::max();
  std::vector<double> values = {-kMax, 0.0, kMax};
  const Statistics s = summarize(values);
  EXPECT_EQ(s.mean, 0.0);
  EXPECT_EQ(s.histogram.edges.front(), -kMax);
  EXPECT_EQ(s.histogram.edges.back(), kMax);
  EXPECT_EQ(counted(s.histogram), 3U);
}

TEST(Summarize, MeanIsRightWhereTheTotalOverflows) {
  std::vector<double> values = {1e308, 1.5e308, 0.5e308, 0.0};
  const Statistics s = summarize(values);
  EXPECT_TRUE(std::isinf(s.total));
  EXPECT_NEAR(s.mean / 1e308, 0.75, 1e-15);
  for (double& value : values) value = -value;
  EXPECT_NEAR(summarize(values).mean / 1e308, -0.75, 1e-15);
}

TEST(Summarize, SmallValuesBesideHugeOnesAreNotLost) {
  // Plain summation in this order gives 0: each 1 is lost beside 1e100.
  std::vector<double> values = {1.0, 1e100, 1.0, -1e100};
  EXPECT_EQ(summarize(values).total, 2.0);
}

TEST(Summarize, IsTheSameForAnyNumberOfThreads) {
  std::mt19937_64 random(11);
  std::lognormal_distribution<double> skewed(0.0, 3.0);
  std::vector<double> values(200000);
  std::generate(values.begin(), values.end(), [&] { return skewed(random); });
  std::vector<double> copy = values;
  const auto summary_with = [](std::vector<double>& list, std::size_t threads) {
    const ThreadLimit limit(threads);
    return summarize(list);
  };
  const Statistics one = summary_with(values, 1);
  const Statistics many = summary_with(copy, 4);
  EXPECT_EQ(one.total, many.total);
  EXPECT_EQ(one.variance, many.variance);
  EXPECT_EQ(one.median, many.median);
  EXPECT_EQ(one.histogram.counts, many.histogram.counts);
}

}  // namespace
}  // namespace meshalyzer
