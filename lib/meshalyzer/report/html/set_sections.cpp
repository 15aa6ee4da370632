#include "meshalyzer/report/html/set_sections.h"

#include "meshalyzer/report/html/attribute_tables.h"
#include "meshalyzer/report/html/statistics_section.h"
#include "meshalyzer/report/text/meetings.h"
#include "meshalyzer/report/text/separation.h"
#include "meshalyzer/report/text/set_totals.h"

#include <string>

namespace meshalyzer {
namespace {

void append_totals_section(HtmlWriter& html, const SetAnalysis& set) {
  const HtmlSection section(html, "totals", "Totals");
  ReportRows rows;
  rows.line("meshes", set.meshes);
  rows.line("unreadable files", set.unreadable);
  append_set_totals(rows, set);
  append_rows(html, rows);
}

void append_meetings_section(HtmlWriter& html, const SetAnalysis& set) {
  if (!set.intersections) return;
  const HtmlSection section(html, "between", "Intersections between meshes");
  ReportRows rows;
  append_meeting_counts(rows, set);
  append_rows(html, rows);
  if (set.intersections->n_pairs() == 0) return;
  html.element("h3", "Pairs of meshes that intersect");
  append_text_table(html, meetings_table(set), TableOrder::ByColumn);
}

void append_separation_section(HtmlWriter& html, const SetAnalysis& set) {
  if (!set.separation && set.separation_reason.empty()) return;
  const HtmlSection section(html, "separation", "Separation distances");
  if (!set.separation) {
    std::string text = "Not measured: ";
    text += set.separation_reason;
    html.element("p", text);
    return;
  }
  ReportRows rows;
  append_separation_options(rows, *set.separation);
  append_separation_counts(rows, *set.separation);
  append_rows(html, rows);
  append_text_table(html, separation_table(set), TableOrder::ByColumn);
  append_figures(html, kSeparationDistance, set.separation->all);
}

}  // namespace

void append_set_sections(HtmlWriter& html, const SetAnalysis& set) {
  append_totals_section(html, set);
  append_meetings_section(html, set);
  append_separation_section(html, set);
  if (set.statistics) append_statistics_section(html, *set.statistics);
}

}  // namespace meshalyzer
