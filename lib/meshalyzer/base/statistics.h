#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace meshalyzer {

/// A histogram with bins of equal width from the smallest to the largest value.
struct Histogram {
  static constexpr std::size_t kBins = 16;
  /// The edges of the bins, ascending. Bin i holds edges[i] <= value < edges[i + 1]; the last bin
  /// also holds its upper edge.
  std::array<double, kBins + 1> edges{};
  std::array<std::size_t, kBins> counts{};
};

/// Summarises a set of real values in a few figures.
struct Summary {
  /// The number of finite values; the figures below describe only these.
  std::size_t count = 0;
  /// The number of infinite values, which no other figure includes.
  std::size_t infinite = 0;
  double min = 0.0;
  double max = 0.0;
  double mean = 0.0;
  /// The middle value; the mean of the two middle ones where count is even.
  double median = 0.0;
  /// The sample variance, with n - 1 in the denominator; 0 where count is 1.
  double variance = 0.0;
  double total = 0.0;
};

/// A summary with the distribution of the values.
struct Statistics : Summary {
  Histogram histogram;
};

/// Summarises values. With count 0 every figure is 0 and has no meaning.
///
/// Sums are compensated and their order depends on the number of values alone, so that the result
/// is the same for any number of threads.
///
/// @param values  The values, without NaN. They are reordered: the median is found by selection in
///                place.
/// @complexity    O(n) time, O(1) additional memory.
[[nodiscard]] Statistics summarize(std::span<double> values);

}  // namespace meshalyzer
