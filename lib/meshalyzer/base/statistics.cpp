#include "meshalyzer/base/statistics.h"

#include "meshalyzer/base/select_nth.h"
#include "meshalyzer/base/statistics_passes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace meshalyzer {
namespace {

double median_of(std::span<double> values) {
  const std::size_t nth = lower_middle(values.size());
  const auto lower = values.begin() + static_cast<std::ptrdiff_t>(nth);
  select_nth(values, nth, [](double value) { return ordered_bits(value); });
  const bool has_one_middle = values.size() % 2 == 1;
  return median_of_middle(*lower,
                          has_one_middle ? *lower : *std::min_element(lower + 1, values.end()));
}

}  // namespace

Statistics summarize(std::span<double> values) {
  const auto infinite_begin = std::stable_partition(values.begin(), values.end(),
                                                    [](double v) { return std::isfinite(v); });
  const std::span<double> finite(values.begin(), infinite_begin);
  Statistics result;
  if (!finite.empty()) {
    ExtentPass extent;
    extent.add(finite);
    SpreadPass spread(extent);
    spread.add(finite);
    result = spread.statistics();
    result.median = median_of(finite);
  }
  result.infinite = values.size() - finite.size();
  return result;
}

}  // namespace meshalyzer
