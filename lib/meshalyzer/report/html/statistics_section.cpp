#include "meshalyzer/report/html/statistics_section.h"

#include "meshalyzer/report/html/attribute_tables.h"
#include "meshalyzer/report/html/histogram_svg.h"
#include "meshalyzer/report/text/curvature.h"

#include <array>
#include <cstddef>
#include <string>

namespace meshalyzer {
namespace {

void append_figure_table(HtmlWriter& html, const QuantityName& quantity,
                         const Statistics& statistics) {
  ReportRows rows;
  rows.line("count", statistics.count);
  if (statistics.infinite > 0) rows.line("infinite (left out)", statistics.infinite);
  rows.line("min", statistics.min);
  rows.line("max", statistics.max);
  rows.line("mean", statistics.mean);
  rows.line("median", statistics.median);
  rows.line("variance", statistics.variance);
  if (quantity.total == QuantityName::Total::Show) rows.line("total", statistics.total);
  const HtmlElement box(html, "div", {{"class", "figures"}});
  append_rows(html, rows);
}

void append_bins(HtmlWriter& html, const Histogram& histogram) {
  const HtmlElement details(html, "details");
  html.element("summary", "Numbers");
  const auto edges = edge_texts(histogram);
  TextTable table{0, {{"from", "to", "count"}}};
  for (std::size_t bin = 0; bin < Histogram::kBins; ++bin) {
    table.rows.push_back({edges[bin], edges[bin + 1], std::to_string(histogram.counts[bin])});
  }
  append_text_table(html, table);
}

std::string none_text(const QuantityName& quantity, const Statistics& statistics) {
  std::string text = "undefined (";
  text += quantity.if_none;
  text += ')';
  if (statistics.infinite > 0) {
    text += "; infinite: ";
    text += std::to_string(statistics.infinite);
  }
  return text;
}

void append_curvatures(HtmlWriter& html, const CurvatureStatistics& curvature) {
  const HtmlSection section(html, "curvature", "Curvature");
  ReportRows rows;
  append_curvature_counts(rows, curvature);
  append_rows(html, rows);
  for_each_curvature(curvature, [&](const QuantityName& quantity, const Statistics& statistics) {
    append_figures(html, quantity, statistics);
  });
}

template <typename Measures>
void append_measured(HtmlWriter& html, const Measures& measures) {
  const HtmlSection section(html, "statistics", "Statistics");
  for_each_measure(measures, [&](const QuantityName& quantity, const Statistics& statistics) {
    append_figures(html, quantity, statistics);
  });
}

}  // namespace

void append_figures(HtmlWriter& html, const QuantityName& quantity, const Statistics& statistics) {
  const HtmlElement figure(html, "figure", {{"class", "histogram"}});
  {
    const HtmlElement caption(html, "figcaption");
    append_term(html, quantity.name);
  }
  if (statistics.count == 0) {
    html.element("p", none_text(quantity, statistics));
    return;
  }
  const bool has_histogram = statistics.min != statistics.max;
  if (has_histogram) append_histogram_svg(html, quantity.name, statistics.histogram);
  append_figure_table(html, quantity, statistics);
  if (has_histogram) {
    append_bins(html, statistics.histogram);
  } else {
    html.element("p", "No histogram: all values are the same.");
  }
}

void append_statistics_section(HtmlWriter& html, const Analysis& analysis) {
  append_measured(html, analysis.characteristics);
  if (analysis.curvature) append_curvatures(html, *analysis.curvature);
}

void append_statistics_section(HtmlWriter& html, const SetStatistics& statistics) {
  append_measured(html, statistics);
}

}  // namespace meshalyzer
