#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/base/sum.h"

#include <cstddef>
#include <limits>
#include <span>

namespace meshalyzer {

/// The first pass over finite values: how many they are, their bounds and their sum.
///
/// The passes take the values in spans, one after the other. Where the spans end makes no
/// difference to the last bit, as long as all but the last have a multiple of kChunkLength values.
class ExtentPass {
 public:
  void add(std::span<const double> values);

  [[nodiscard]] std::size_t count() const { return count_; }
  /// Returns the smallest value; infinity where there is none.
  [[nodiscard]] double min() const { return min_; }
  [[nodiscard]] double max() const { return max_; }
  [[nodiscard]] double total() const { return total_.value(); }
  [[nodiscard]] double mean() const;

 private:
  std::size_t count_ = 0;
  double min_ = std::numeric_limits<double>::infinity();
  double max_ = -std::numeric_limits<double>::infinity();
  CompensatedSum total_;
};

/// The second pass over the same values: how they spread.
class SpreadPass {
 public:
  /// @param extent  Of all the values; at least one.
  explicit SpreadPass(const ExtentPass& extent);

  void add(std::span<const double> values);

  /// All figures but the median, which is 0, and the number of infinite values, too.
  [[nodiscard]] Statistics statistics() const;

 private:
  ExtentPass extent_;
  double mean_ = 0.0;
  CompensatedSum squared_deviations_;
  Histogram histogram_;
};

/// Returns the index of the lower of the two middle ones among `count` sorted values, or of the
/// only middle one where count is odd.
[[nodiscard]] constexpr std::size_t lower_middle(std::size_t count) {
  return (count - 1) / 2;
}

/// Returns the median by the two middle values: the same value twice where the count is odd. Never
/// -0, which selection cannot tell from 0.
[[nodiscard]] double median_of_middle(double lower, double upper);

}  // namespace meshalyzer
