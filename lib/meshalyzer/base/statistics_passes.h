#pragma once

#include "meshalyzer/base/statistics.h"
#include "meshalyzer/base/sum.h"

#include <cstddef>
#include <limits>
#include <span>

namespace meshalyzer {

/// The first pass over finite values, which finds their number, bounds and sum.
///
/// The passes take the values in spans, one after the other. The result is the same to the last bit
/// wherever the spans end, as long as all but the last have a multiple of kChunkLength values.
class ExtentPass {
 public:
  void add(std::span<const double> values);

  [[nodiscard]] std::size_t count() const { return count_; }
  /// Returns the smallest value, or infinity when there is none.
  [[nodiscard]] double min() const { return min_; }
  [[nodiscard]] double max() const { return max_; }
  [[nodiscard]] double total() const { return total_.value(); }
  /// Returns the mean, also where the total is too large for a double.
  [[nodiscard]] double mean() const;

 private:
  std::size_t count_ = 0;
  double min_ = std::numeric_limits<double>::infinity();
  double max_ = -std::numeric_limits<double>::infinity();
  CompensatedSum total_;
  /// The sum of a small share of each value, from which the mean follows where the total overflows.
  CompensatedSum small_total_;
};

/// The second pass over the same values, which finds their variance and histogram.
class SpreadPass {
 public:
  /// @param extent  The result of the first pass over all the values, at least one.
  explicit SpreadPass(const ExtentPass& extent);

  void add(std::span<const double> values);

  /// Returns all figures except the median and the number of infinite values, which are 0.
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

/// Returns the median from the two middle values, which are the same value where the count is odd.
/// The result is never -0, which selection cannot distinguish from 0.
[[nodiscard]] double median_of_middle(double lower, double upper);

}  // namespace meshalyzer
