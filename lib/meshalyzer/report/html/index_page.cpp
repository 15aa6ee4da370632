#include "meshalyzer/report/html/index_page.h"

#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/report/html/attribute_tables.h"
#include "meshalyzer/report/html/index_table.h"
#include "meshalyzer/report/html/page_frame.h"
#include "meshalyzer/report/html/set_notes.h"
#include "meshalyzer/report/html/statistics_section.h"
#include "meshalyzer/report/html/writer.h"
#include "meshalyzer/report/set_verdict.h"
#include "meshalyzer/report/text/meetings.h"
#include "meshalyzer/report/text/separation.h"
#include "meshalyzer/report/text/set_totals.h"
#include "meshalyzer/set/set_analysis.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

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
    html.element("p", "Not measured: " + set.separation_reason);
    return;
  }
  ReportRows rows;
  append_separation_options(rows, *set.separation);
  append_separation_counts(rows, *set.separation);
  append_rows(html, rows);
  append_text_table(html, separation_table(set), TableOrder::ByColumn);
  append_figures(html, kSeparationDistance, set.separation->all);
}

/// Appends the sections about a set as a whole: totals, intersections, separation, statistics.
void append_set_sections(HtmlWriter& html, const SetAnalysis& set) {
  append_totals_section(html, set);
  append_meetings_section(html, set);
  append_separation_section(html, set);
  if (set.statistics) append_statistics_section(html, *set.statistics);
}

std::size_t count_if_row(const std::vector<IndexRow>& rows, RowState state) {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [&](const IndexRow& row) { return state_of(row) == state; }));
}

Verdict verdict_of_all(const std::vector<IndexRow>& rows, const SetAnalysis* set) {
  Verdict verdict{Verdict::Kind::Bad, "Not good"};
  append_reasons_within(count_if_row(rows, RowState::NotGood),
                        count_if_row(rows, RowState::Unreadable), verdict.reasons);
  if (set != nullptr && set->intersections) {
    append_reasons_between(*set->intersections, verdict.reasons);
  }
  if (!verdict.reasons.empty()) return verdict;
  if (count_if_row(rows, RowState::Good) == 0) return {};
  return {Verdict::Kind::Good, "Good"};
}

std::string facts_of(const std::vector<IndexRow>& rows) {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (const IndexRow& row : rows) {
    vertices += row.vertices;
    faces += row.faces;
  }
  const std::size_t n_meshes = rows.size() - count_if_row(rows, RowState::Unreadable);
  return counted(n_meshes, "mesh", "meshes") + ", " + size_text(faces, vertices);
}

}  // namespace

IndexRow index_row(const Analysis& analysis, const DefectReport& defects, std::string name,
                   std::string page) {
  IndexRow row{.name = std::move(name), .page = std::move(page)};
  if (const std::optional<Goodness>& goodness = verdict_of(analysis)) {
    row.good = goodness->good;
    row.reasons = goodness->reasons;
  }
  row.vertices = analysis.characteristics.vertices;
  row.faces = analysis.characteristics.faces;
  if (analysis.has_characteristics) {
    row.area = analysis.characteristics.area;
    row.volume = analysis.characteristics.volume.value;
  }
  row.defects = defects.counts;
  return row;
}

std::string html_index(const std::vector<IndexRow>& rows, const SetAnalysis* set) {
  const PageHeader header{
      .name = "All meshes", .verdict = verdict_of_all(rows, set), .facts = facts_of(rows)};
  return html_page(header, {}, [&](HtmlWriter& html) {
    append_meshes_section(
        html, rows, set == nullptr ? std::vector<std::vector<std::string>>{} : set_notes(*set));
    if (set != nullptr) append_set_sections(html, *set);
  });
}

}  // namespace meshalyzer
