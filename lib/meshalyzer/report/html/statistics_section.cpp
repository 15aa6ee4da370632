#include "meshalyzer/report/html/statistics_section.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/report/figures.h"
#include "meshalyzer/report/html/attribute_tables.h"
#include "meshalyzer/report/html/histogram_svg.h"
#include "meshalyzer/report/text/curvature.h"
#include "meshalyzer/report/text/statistics.h"

#include <array>
#include <cstddef>
#include <string>

namespace meshalyzer {
namespace {

void append_figure_table(HtmlWriter& html, const Quantity& quantity, const Statistics& statistics) {
  ReportRows rows;
  rows.line("count", statistics.count);
  if (statistics.infinite > 0) rows.line("infinite (left out)", statistics.infinite);
  for (const FieldRow<Summary, double>& figure : kFigures) {
    if (is_shown(figure, quantity)) rows.line(figure.info.label, statistics.*figure.member);
  }
  const HtmlElement box(html, "div", {{"class", "figures"}});
  append_rows(html, rows);
}

void append_bins(HtmlWriter& html, const Histogram& histogram) {
  const HtmlElement details(html, "details");
  html.element("summary", "Numbers");
  const auto edges = edge_texts(histogram);
  TextTable table{0, {{"from", "to", "count"}}};
  for (std::size_t bin = 0; bin < Histogram::kBins; ++bin) {
    table.rows.push_back({edges[bin], edges[bin + 1], grouped(histogram.counts[bin])});
  }
  append_text_table(html, table);
}

std::string none_text(const Quantity& quantity, const Statistics& statistics) {
  std::string text = undefined(quantity.if_none);
  if (statistics.infinite > 0) text += "; infinite: " + grouped(statistics.infinite);
  return text;
}

void append_curvatures(HtmlWriter& html, const CurvatureStatistics& curvature) {
  const HtmlSection section(html, "curvature", "Curvature");
  ReportRows rows;
  append_curvature_counts(rows, curvature);
  append_rows(html, rows);
  for (const auto& [quantity, member] : kCurvatures) {
    append_figures(html, quantity, curvature.*member);
  }
}

}  // namespace

void append_figures(HtmlWriter& html, const Quantity& quantity, const Statistics& statistics) {
  const HtmlElement figure(html, "figure", {{"class", "histogram"}});
  {
    const HtmlElement caption(html, "figcaption");
    append_term(html, quantity.info.label);
  }
  if (statistics.count == 0) {
    html.element("p", none_text(quantity, statistics));
    return;
  }
  const bool has_histogram = statistics.min != statistics.max;
  if (has_histogram) append_histogram_svg(html, quantity.info.label, statistics.histogram);
  append_figure_table(html, quantity, statistics);
  if (has_histogram) {
    append_bins(html, statistics.histogram);
  } else {
    html.element("p", "No histogram: all values are the same.");
  }
}

void append_statistics_sections(HtmlWriter& html, const Analysis& analysis) {
  append_statistics_section(html, analysis.characteristics);
  if (analysis.curvature) append_curvatures(html, *analysis.curvature);
}

void append_statistics_section(HtmlWriter& html, const ElementMeasures<Statistics>& measures) {
  const HtmlSection section(html, "statistics", "Statistics");
  for (const auto& [quantity, member] : kElementMeasures<Statistics>) {
    append_figures(html, quantity, measures.*member);
  }
}

}  // namespace meshalyzer
