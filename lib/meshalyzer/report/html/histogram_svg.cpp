#include "meshalyzer/report/html/histogram_svg.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/report/text/statistics.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <fmt/format.h>
#include <string>

namespace meshalyzer {
namespace {

// The dimensions of the drawing in its own units, about a pixel each.
constexpr double kWidth = 480.0;
constexpr double kHeight = 170.0;
constexpr double kLeft = 52.0;
constexpr double kRight = 460.0;
constexpr double kTop = 12.0;
constexpr double kBottom = 146.0;
constexpr double kGap = 1.5;
constexpr double kPitch = (kRight - kLeft) / static_cast<double>(Histogram::kBins);
/// Labels longer than this would overlap below every fourth bin.
constexpr std::size_t kLongLabel = 14;

std::string number(double coordinate) {
  return fmt::format("{:.6g}", coordinate);
}

double x_of_edge(std::size_t edge) {
  return kLeft + kPitch * static_cast<double>(edge);
}

/// Maps counts to heights.
struct CountAxis {
  std::size_t most = 1;

  [[nodiscard]] double height(std::size_t count) const {
    return (kBottom - kTop) * static_cast<double>(count) / static_cast<double>(most);
  }
  /// Returns the distance of the lines: the smallest of 1, 2 or 5 times a power of ten that leaves
  /// at most four lines.
  [[nodiscard]] std::size_t step() const {
    for (std::size_t power = 1;; power *= 10) {
      for (const std::size_t digit : {1U, 2U, 5U}) {
        if (most / (digit * power) < 5) return digit * power;
      }
    }
  }
};

void append_label(HtmlWriter& html, double x, double y, std::string_view anchor,
                  std::string_view text) {
  html.element("text",
               {{"class", "tick"},
                {"x", number(x)},
                {"y", number(y)},
                {"text-anchor", anchor},
                {"font-size", "11"},
                {"fill", "currentColor"}},
               text);
}

void append_level(HtmlWriter& html, std::string_view kind, double y) {
  html.element("line",
               {{"class", kind},
                {"x1", number(kLeft)},
                {"x2", number(kRight)},
                {"y1", number(y)},
                {"y2", number(y)},
                {"stroke", "currentColor"},
                {"stroke-width", "0.75"}},
               "");
}

void append_count_axis(HtmlWriter& html, const CountAxis& axis) {
  const std::size_t step = axis.step();
  for (std::size_t count = step; count <= axis.most; count += step) {
    const double y = kBottom - axis.height(count);
    append_level(html, "grid", y);
    append_label(html, kLeft - 6.0, y + 4.0, "end", grouped(count));
  }
}

using EdgeTexts = std::array<std::string, Histogram::kBins + 1>;

void append_value_axis(HtmlWriter& html, const EdgeTexts& edges) {
  append_level(html, "axis", kBottom);
  const bool is_long = std::any_of(
      edges.begin(), edges.end(), [](const std::string& text) { return text.size() > kLongLabel; });
  if (is_long) {
    append_label(html, kLeft, kBottom + 16.0, "start", edges.front());
    append_label(html, kRight, kBottom + 16.0, "end", edges.back());
    return;
  }
  for (std::size_t edge = 0; edge < edges.size(); edge += 4) {
    append_label(html, x_of_edge(edge), kBottom + 16.0, "middle", edges[edge]);
  }
}

void append_bar(HtmlWriter& html, std::size_t bin, double height, std::string_view title) {
  const HtmlElement bar(html, "rect",
                        {{"class", "bar"},
                         {"x", number(x_of_edge(bin) + kGap / 2.0)},
                         {"y", number(kBottom - height)},
                         {"width", number(kPitch - kGap)},
                         {"height", number(height)},
                         {"fill", "currentColor"}});
  html.element("title", title);
}

}  // namespace

void append_histogram_svg(HtmlWriter& html, std::string_view name, const Histogram& histogram) {
  const EdgeTexts edges = edge_texts(histogram);
  const CountAxis axis{std::max<std::size_t>(
      1, *std::max_element(histogram.counts.begin(), histogram.counts.end()))};
  const std::string label = fmt::format("Histogram of {} from {} to {}, at most {} in a bin", name,
                                        edges.front(), edges.back(), grouped(axis.most));
  const std::string view_box = fmt::format("0 0 {} {}", kWidth, kHeight);
  const HtmlElement svg(html, "svg",
                        {{"role", "img"}, {"aria-label", label}, {"viewBox", view_box}});
  append_count_axis(html, axis);
  for (std::size_t bin = 0; bin < Histogram::kBins; ++bin) {
    const std::size_t count = histogram.counts[bin];
    if (count == 0) continue;
    append_bar(html, bin, axis.height(count),
               fmt::format("{} .. {}: {}", edges[bin], edges[bin + 1], grouped(count)));
  }
  append_value_axis(html, edges);
}

}  // namespace meshalyzer
