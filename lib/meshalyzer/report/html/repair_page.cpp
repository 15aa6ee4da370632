#include "meshalyzer/report/html/repair_page.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/report/format_text.h"
#include "meshalyzer/report/html/attribute_tables.h"
#include "meshalyzer/report/html/defect_list.h"
#include "meshalyzer/report/html/page_frame.h"
#include "meshalyzer/report/text/repair_lines.h"

#include <array>
#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

/// Counts the defects that remain and were not to be fixed: for the analysis they may be reasons
/// why the mesh is not good.
std::vector<std::string> counts_not_asked_for(const RepairReport& report) {
  std::vector<std::string> counts = counts_of_codes(
      [&](DefectCode code) {
        return report.fixes.contains(code) ? 0 : n_remaining(report, {code});
      },
      DefectCodes::all());
  for (std::string& count : counts) count += " (not asked for)";
  return counts;
}

Verdict verdict_of(const RepairReport& report) {
  const std::size_t n = n_remaining(report);
  if (n != 0) {
    return {Verdict::Kind::Bad, counted(n, "defect remains", "defects remain"),
            counts_of_codes([&](DefectCode code) { return n_remaining(report, {code}); },
                            report.fixes)};
  }
  if (may_have_more(report)) {
    return {Verdict::Kind::Bad, "Defects may remain: a search ended early"};
  }
  return {Verdict::Kind::Good,
          report.result.log.steps.empty() ? "Nothing was to be done" : "Repaired",
          counts_not_asked_for(report)};
}

std::string facts_of(const RepairReport& report) {
  return fmt::format("faces {} \u2192 {}, vertices {} \u2192 {}, {}", grouped(report.input.n_faces),
                     grouped(n_final_faces(report)), grouped(report.input.n_vertices),
                     grouped(n_final_vertices(report)),
                     file_text(report.input.path, report.input.format));
}

/// Appends the section with the counts of defects before and after.
void append_counts_section(HtmlWriter& html, const RepairReport& report) {
  const HtmlSection section(html, "counts", "Defects before and after");
  TextTable table{2, {{"defect", "asked for", "before", "after"}}};
  std::size_t before = 0;
  std::size_t after = 0;
  for (const DefectCode code : all_defect_codes()) {
    const std::size_t was = report.result.before.count(code);
    const std::size_t is = n_remaining(report, {code});
    before += was;
    after += is;
    if (was == 0 && is == 0) continue;
    table.rows.push_back({std::string(defect_name(code)),
                          report.fixes.contains(code) ? "yes" : "no", grouped(was), grouped(is)});
  }
  table.rows.push_back({"all", "", grouped(before), grouped(after)});
  append_text_table(html, table);
}

void append_steps(HtmlWriter& html, const std::vector<LogStep>& steps) {
  if (steps.empty()) {
    html.element("p", "Nothing was changed.");
    return;
  }
  TextTable table{2, {{"pass", "in words", "changes", "largest move"}}};
  for (const LogStep& step : steps) {
    table.rows.push_back({step.pass, step_text(step), grouped(step.operations),
                          step.distance == 0.0 ? "-" : readable(step.distance)});
  }
  append_text_table(html, table);
}

void append_repair_section(HtmlWriter& html, const RepairReport& report) {
  const HtmlSection section(html, "repair", "What was done");
  append_steps(html, report.result.log.steps);
  html.element("h3", "What came out");
  ReportRows rows;
  append_outcome(rows, report);
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
