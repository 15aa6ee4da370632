#include "meshalyzer/report/text/statistics.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <vector>

namespace meshalyzer {
namespace {

template <typename Texts>
std::size_t widest(const Texts& texts) {
  std::size_t width = 0;
  for (const std::string& text : texts) {
    width = std::max(width, text.size());
  }
  return width;
}

void append_histogram(std::string& text, const Histogram& histogram) {
  const auto edges = edge_texts(histogram);
  std::array<std::string, Histogram::kBins> counts;
  std::transform(histogram.counts.begin(), histogram.counts.end(), counts.begin(),
                 [](std::size_t count) { return std::to_string(count); });
  const std::size_t edge_width = widest(edges);
  const std::size_t count_width = widest(counts);
  constexpr std::size_t kRows = Histogram::kBins / 2;
  for (std::size_t row = 0; row < kRows; ++row) {
    for (const std::size_t bin : {row, row + kRows}) {
      fmt::format_to(std::back_inserter(text), "{}{:>{}} .. {:>{}}: {:>{}}",
                     bin == row ? "  " : "    |    ", edges[bin], edge_width, edges[bin + 1],
                     edge_width, counts[bin], count_width);
    }
    text += '\n';
  }
}

}  // namespace

std::array<std::string, Histogram::kBins + 1> edge_texts(const Histogram& histogram) {
  std::array<std::string, Histogram::kBins + 1> texts;
  for (int digits = 4; digits <= 17; ++digits) {
    std::transform(histogram.edges.begin(), histogram.edges.end(), texts.begin(),
                   [&](double edge) { return fmt::format("{:.{}g}", edge + 0.0, digits); });
    if (std::adjacent_find(texts.begin(), texts.end()) == texts.end()) {
      break;
    }
  }
  return texts;
}

void append_statistics(TextLines& lines, const QuantityName& quantity,
                       const Statistics& statistics) {
  const std::string name(quantity.name);
  if (statistics.infinite > 0) {
    lines.line(name + " infinite",
               fmt::format("{} (left out of the figures below)", statistics.infinite));
  }
  if (statistics.count == 0) {
    lines.line(name, fmt::format("undefined ({})", quantity.if_none));
    return;
  }
  lines.line(name + " count", statistics.count);
  lines.line(name + " min", statistics.min);
  lines.line(name + " max", statistics.max);
  lines.line(name + " mean", statistics.mean);
  lines.line(name + " median", statistics.median);
  lines.line(name + " variance", statistics.variance);
  if (quantity.total == QuantityName::Total::Show) {
    lines.line(name + " total", statistics.total);
  }
  if (statistics.min == statistics.max) {
    lines.line(name + " histogram", "none (all values are the same)");
    return;
  }
  lines.line(name + " histogram", "16 bins of equal width");
  append_histogram(lines.text(), statistics.histogram);
}

}  // namespace meshalyzer
