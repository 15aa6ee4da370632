#include "meshalyzer/report/text/statistics.h"

#include "meshalyzer/report/figures.h"

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

void append_statistics(TextLines& lines, const Quantity& quantity, const Statistics& statistics) {
  const std::string name(quantity.info.label);
  if (statistics.infinite > 0) {
    lines.line(name + " infinite",
               fmt::format("{} (left out of the figures below)", statistics.infinite));
  }
  if (statistics.count == 0) {
    lines.line(name, undefined(quantity.if_none));
    return;
  }
  lines.line(name + " count", statistics.count);
  for (const FieldRow<Summary, double>& figure : kFigures) {
    if (is_shown(figure, quantity)) {
      lines.line(fmt::format("{} {}", name, figure.info.label), statistics.*figure.member);
    }
  }
  if (statistics.min == statistics.max) {
    lines.line(name + " histogram", "none (all values are the same)");
    return;
  }
  lines.line(name + " histogram", "16 bins of equal width");
  append_histogram(lines.text(), statistics.histogram);
}

void append_measures(TextLines& lines, const ElementMeasures<Statistics>& measures) {
  for (const auto& [quantity, member] : kElementMeasures<Statistics>) {
    append_statistics(lines, quantity, measures.*member);
  }
}

}  // namespace meshalyzer
