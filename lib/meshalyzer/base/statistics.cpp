#include "meshalyzer/base/statistics.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sum.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace meshalyzer {
namespace {

struct Extent {
  double min = 0.0;
  double max = 0.0;
  CompensatedSum total;
};

Extent extent_of(std::span<const double> values) {
  const auto parts = map_chunks<Extent>(values.size(), [&](Chunk chunk) {
    Extent part{values[chunk.begin], values[chunk.begin], {}};
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      part.min = std::min(part.min, values[i]);
      part.max = std::max(part.max, values[i]);
      part.total.add(values[i]);
    }
    return part;
  });
  Extent all{parts.front().min, parts.front().max, {}};
  for (const Extent& part : parts) {
    all.min = std::min(all.min, part.min);
    all.max = std::max(all.max, part.max);
    all.total.add(part.total);
  }
  return all;
}

double sum_of_squared_deviations(std::span<const double> values, double mean) {
  const auto parts = map_chunks<CompensatedSum>(values.size(), [&](Chunk chunk) {
    CompensatedSum part;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      part.add((values[i] - mean) * (values[i] - mean));
    }
    return part;
  });
  CompensatedSum all;
  for (const CompensatedSum& part : parts) {
    all.add(part);
  }
  return all.value();
}

Histogram histogram_of(std::span<const double> values, double min, double max) {
  Histogram histogram;
  // Halves first: max - min may overflow where max / 2 - min / 2 does not.
  const double half_width = max / 2 - min / 2;
  for (std::size_t i = 0; i <= Histogram::kBins; ++i) {
    const double t = static_cast<double>(i) / Histogram::kBins;
    histogram.edges[i] = i == Histogram::kBins ? max : min + 2 * (half_width * t);
  }
  using Counts = std::array<std::size_t, Histogram::kBins>;
  const auto parts = map_chunks<Counts>(values.size(), [&](Chunk chunk) {
    Counts counts{};
    const auto first_inner = histogram.edges.begin() + 1;
    const auto last_inner = histogram.edges.end() - 1;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      ++counts[static_cast<std::size_t>(std::upper_bound(first_inner, last_inner, values[i]) -
                                        first_inner)];
    }
    return counts;
  });
  for (const Counts& part : parts) {
    std::transform(part.begin(), part.end(), histogram.counts.begin(), histogram.counts.begin(),
                   std::plus<>());
  }
  return histogram;
}

double median_of(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) {
    return *middle;
  }
  return *std::max_element(values.begin(), middle) / 2 + *middle / 2;
}

}  // namespace

Statistics summarize(std::span<double> values) {
  const auto infinite_begin = std::stable_partition(values.begin(), values.end(),
                                                    [](double v) { return std::isfinite(v); });
  const std::span<double> finite(values.begin(), infinite_begin);
  Statistics result;
  result.count = finite.size();
  result.infinite = values.size() - finite.size();
  if (finite.empty()) {
    return result;
  }
  const Extent extent = extent_of(finite);
  const auto n = static_cast<double>(finite.size());
  result.min = extent.min;
  result.max = extent.max;
  result.total = extent.total.value();
  result.mean = std::clamp(result.total / n, result.min, result.max);
  result.variance =
      finite.size() < 2 ? 0.0 : sum_of_squared_deviations(finite, result.mean) / (n - 1);
  result.histogram = histogram_of(finite, result.min, result.max);
  result.median = median_of(finite);
  return result;
}

}  // namespace meshalyzer
