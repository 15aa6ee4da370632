#include "meshalyzer/base/statistics_passes.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace meshalyzer {
namespace {

using Edges = std::array<double, Histogram::kBins + 1>;

Edges histogram_edges(double min, double max) {
  Edges edges{};
  // Halves are subtracted: max - min may overflow where max / 2 - min / 2 does not.
  const double half_width = max / 2 - min / 2;
  for (std::size_t i = 0; i < Histogram::kBins; ++i) {
    const double t = static_cast<double>(i) / Histogram::kBins;
    edges[i] = min + 2 * (half_width * t);
  }
  edges.back() = max;
  return edges;
}

/// Finds the bins of values.
class BinSearch {
 public:
  explicit BinSearch(const Edges& edges) : edges_(edges) {
    const double per_half_width = Histogram::kBins / (edges.back() / 2 - edges.front() / 2);
    if (std::isfinite(per_half_width)) per_half_width_ = per_half_width;
  }

  /// Returns the bin of a value that is not outside of all. Rounding may put the first guess next
  /// to it.
  [[nodiscard]] std::size_t bin_of(double value) const {
    const double guess = (value / 2 - edges_.front() / 2) * per_half_width_;
    auto bin = static_cast<std::size_t>(std::min(guess, Histogram::kBins - 1.0));
    while (value < edges_[bin]) --bin;
    while (bin + 1 < Histogram::kBins && value >= edges_[bin + 1]) ++bin;
    return bin;
  }

 private:
  const Edges& edges_;
  /// The number of bins by half of the width of all; 0 if they are too narrow for that.
  double per_half_width_ = 0.0;
};

/// The sum of fewer than 2^64 values of this share of any double is finite.
constexpr double kSmallShare = 0x1p-64;

struct ExtentPart {
  double min = 0.0;
  double max = 0.0;
  CompensatedSum total;
  CompensatedSum small_total;
};

ExtentPart extent_of(std::span<const double> values) {
  ExtentPart part{values.front(), values.front(), {}, {}};
  for (const double value : values) {
    part.min = std::min(part.min, value);
    part.max = std::max(part.max, value);
    part.total.add(value);
    part.small_total.add(value * kSmallShare);
  }
  return part;
}

struct SpreadPart {
  CompensatedSum squared_deviations;
  std::array<std::size_t, Histogram::kBins> counts{};
};

SpreadPart spread_of(std::span<const double> values, double mean, const Edges& edges) {
  const BinSearch bins(edges);
  SpreadPart part;
  for (const double value : values) {
    part.squared_deviations.add((value - mean) * (value - mean));
    ++part.counts[bins.bin_of(value)];
  }
  return part;
}

std::span<const double> values_of(Chunk chunk, std::span<const double> values) {
  return values.subspan(chunk.begin, chunk.end - chunk.begin);
}

}  // namespace

void ExtentPass::add(std::span<const double> values) {
  const auto parts = map_chunks<ExtentPart>(
      values.size(), [&](Chunk chunk) { return extent_of(values_of(chunk, values)); });
  for (const ExtentPart& part : parts) {
    min_ = std::min(min_, part.min);
    max_ = std::max(max_, part.max);
    total_.add(part.total);
    small_total_.add(part.small_total);
  }
  count_ += values.size();
}

double ExtentPass::mean() const {
  const auto count = static_cast<double>(count_);
  const double mean =
      std::isfinite(total()) ? total() / count : small_total_.value() / count / kSmallShare;
  return std::clamp(mean, min_, max_);
}

SpreadPass::SpreadPass(const ExtentPass& extent) : extent_(extent), mean_(extent.mean()) {
  histogram_.edges = histogram_edges(extent.min(), extent.max());
}

void SpreadPass::add(std::span<const double> values) {
  const auto parts = map_chunks<SpreadPart>(values.size(), [&](Chunk chunk) {
    return spread_of(values_of(chunk, values), mean_, histogram_.edges);
  });
  for (const SpreadPart& part : parts) {
    squared_deviations_.add(part.squared_deviations);
    std::transform(part.counts.begin(), part.counts.end(), histogram_.counts.begin(),
                   histogram_.counts.begin(), std::plus<>());
  }
}

Statistics SpreadPass::statistics() const {
  Statistics result;
  result.count = extent_.count();
  result.min = extent_.min();
  result.max = extent_.max();
  result.total = extent_.total();
  result.mean = mean_;
  result.variance = extent_.count() < 2
                        ? 0.0
                        : squared_deviations_.value() / static_cast<double>(extent_.count() - 1);
  result.histogram = histogram_;
  return result;
}

double median_of_middle(double lower, double upper) {
  return std::midpoint(lower, upper) + 0.0;
}

}  // namespace meshalyzer
