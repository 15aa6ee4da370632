#include "meshalyzer/report/html/repair_page.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/report/format_text.h"
#include "meshalyzer/report/html/attribute_tables.h"
#include "meshalyzer/report/html/defect_list.h"
#include "meshalyzer/report/html/page_frame.h"
#include "meshalyzer/report/text/repair_lines.h"
#include "meshalyzer/report/text/short_list.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

std::size_t n_left(const RepairReport& report, DefectCode code) {
  std::size_t n = 0;
  for (const FinalMesh& mesh : report.meshes) n += mesh.remaining.count(code);
  return n;
}

Verdict verdict_of(const RepairReport& report) {
  const std::size_t n = n_remaining(report);
  if (n != 0) {
    std::string text = counted(n, "defect remains", "defects remain");
    return {Verdict::Kind::Bad, text,
            counts_of_codes([&](DefectCode code) { return n_left(report, code); }, report.fixes)};
  }
  if (may_have_more(report)) {
    return {Verdict::Kind::Bad, "Defects may remain: a search ended early"};
  }
  return {Verdict::Kind::Good,
          report.result.log.steps.empty() ? "Nothing was to be done" : "Repaired"};
}

/// Replaces the ASCII arrow in a text by the character.
std::string with_drawn_arrow(std::string text) {
  constexpr std::string_view kArrow = " -> ";
  const std::size_t place = text.find(kArrow);
  if (place != std::string::npos) text.replace(place, kArrow.size(), " \u2192 ");
  return text;
}

std::string facts_of(const RepairReport& report) {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (const FinalMesh& mesh : report.meshes) {
    vertices += mesh.name.n_vertices;
    faces += mesh.name.n_faces;
  }
  std::string facts = "faces " + grouped(report.input.n_faces) + " \u2192 " + grouped(faces);
  facts += ", vertices " + grouped(report.input.n_vertices) + " \u2192 " + grouped(vertices);
  facts += ", ";
  facts += file_text(report.input.path, report.input.format);
  return facts;
}

/// Appends the section with the counts of defects before and after.
void append_counts_section(HtmlWriter& html, const RepairReport& report) {
  const HtmlSection section(html, "counts", "Defects before and after");
  TextTable table{2, {{"defect", "asked for", "before", "after"}}};
  std::size_t before = 0;
  std::size_t after = 0;
  for (const DefectCode code : all_defect_codes()) {
    const std::size_t was = report.result.before.count(code);
    const std::size_t is = n_left(report, code);
    before += was;
    after += is;
    if (was == 0 && is == 0) continue;
    table.rows.push_back({std::string(defect_name(code)),
                          report.fixes.contains(code) ? "yes" : "no", std::to_string(was),
                          std::to_string(is)});
  }
  table.rows.push_back({"all", "", std::to_string(before), std::to_string(after)});
  append_text_table(html, table);
}

void append_steps(HtmlWriter& html, const std::vector<LogStep>& steps) {
  if (steps.empty()) {
    html.element("p", "Nothing was changed.");
    return;
  }
  TextTable table{2, {{"pass", "in words", "changes", "largest move"}}};
  for (const LogStep& step : steps) {
    table.rows.push_back({step.pass, step_text(step), std::to_string(step.operations),
                          step.distance == 0.0 ? "-" : readable(step.distance)});
  }
  append_text_table(html, table);
}

void append_repair_section(HtmlWriter& html, const RepairReport& report) {
  const HtmlSection section(html, "repair", "What was done");
  append_steps(html, report.result.log.steps);
  html.element("h3", "What came out");
  ReportRows outcome;
  append_outcome(outcome, report);
  ReportRows rows;
  for (const ReportRow& row : outcome.rows()) {
    const bool is_count = row.name == "vertices" || row.name == "faces";
    rows.line(row.name, is_count ? with_drawn_arrow(row.value) : row.value);
  }
  append_rows(html, rows);
}

/// Appends the places that were left unchanged, mesh by mesh, with the reason.
void append_refusals_section(HtmlWriter& html, const RepairReport& report) {
  const KeyIds ids(report);
  const std::vector<RefusalGroup> groups = group_refusals(report, ids);
  if (groups.empty()) return;
  const HtmlSection section(html, "refusals", "What was left, and why");
  ReportRows rows;
  for (const RefusalGroup& group : groups) {
    if (report.meshes.size() > 1 && group.mesh) rows.line("mesh", mesh_text(report, *group.mesh));
    append_refusal(rows, group, ListLength::Short);
  }
  append_rows(html, rows);
}

}  // namespace

std::string html_report(const RepairPage& page) {
  const std::array drawn{TitledMesh{"before", page.before}, TitledMesh{"after", page.after}};
  const PageHeader header{.name = file_name(page.report.input.path),
                          .verdict = verdict_of(page.report),
                          .facts = facts_of(page.report)};
  return html_page(header, drawn, [&](HtmlWriter& html) {
    append_counts_section(html, page.report);
    append_repair_section(html, page.report);
    append_refusals_section(html, page.report);
    append_changes_section(html, drawn);
    append_defects_section(html, drawn);
  });
}

}  // namespace meshalyzer
