#include "meshalyzer/report/text/repair_report.h"

#include "meshalyzer/report/key_ids.h"
#include "meshalyzer/report/text/defect_lines.h"
#include "meshalyzer/report/text/patch_lines.h"
#include "meshalyzer/report/text/repair_lines.h"
#include "meshalyzer/report/text/short_list.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

void append_elements(std::string& text, std::string_view what,
                     const std::vector<std::int64_t>& ids) {
  if (ids.empty()) return;
  text += ", ";
  text += what;
  append_ids(text, ids, ListLength::Full);
}

std::string operation_text(const LoggedOperation& operation, const KeyIds& ids) {
  std::string text;
  append_elements(text, "removed faces", ids.faces(operation.removed_faces));
  append_elements(text, "added faces", ids.faces(operation.added_faces));
  append_elements(text, "changed faces", ids.faces(operation.changed_faces));
  append_elements(text, "removed vertices", ids.vertices(operation.removed_vertices));
  append_elements(text, "added vertices", ids.vertices(operation.added_vertices));
  append_elements(text, "moved vertices", ids.vertices(operation.moved_vertices));
  append_distance(text, operation.distance);
  return text.empty() ? ", ids or normals only" : text;
}

void append_steps(TextLines& lines, const RepairReport& report, const KeyIds& ids,
                  ListLength lists) {
  lines.heading("WHAT WAS DONE");
  const RepairLog& log = report.result.log;
  if (log.steps.empty()) lines.line("changes", "none");
  auto next = log.operations.begin();
  for (std::size_t i = 0; i < log.steps.size(); ++i) {
    lines.line(log.steps[i].pass, step_text(log.steps[i]));
    for (; next != log.operations.end() && next->step == i; ++next) {
      if (lists == ListLength::Short) continue;
      lines.line("change", log.steps[i].pass + operation_text(*next, ids));
    }
  }
}

/// Appends the places left unchanged in one of the meshes or, if none is given, in removed parts.
void append_refusals(TextLines& lines, const std::vector<RefusalGroup>& groups,
                     std::optional<std::size_t> mesh, ListLength lists) {
  for (const RefusalGroup& group : groups) {
    if (group.mesh == mesh) append_refusal(lines, group, lists);
  }
}

void append_counts(TextLines& lines, const RepairReport& report) {
  lines.heading("DEFECTS BEFORE AND AFTER");
  std::size_t before = 0;
  std::size_t after = 0;
  for (const DefectCode code : all_defect_codes()) {
    const std::size_t left = n_remaining(report, {code});
    std::string text = arrow(report.result.before.count(code), left);
    if (!report.fixes.contains(code) && left != 0) text += " (not asked for)";
    lines.line(defect_name(code), text);
    before += report.result.before.count(code);
    after += left;
  }
  lines.change("defects", before, after);
  lines.count("asked for and left", n_remaining(report), may_have_more(report));
  for (const CountRise& rise : report.result.rises) {
    lines.line("more than before",
               fmt::format("{} {}", name_of(rise.kind), arrow(rise.before, rise.after)));
  }
}

/// Appends the remaining defects. A short list has only those that were requested; the counts cover
/// the rest.
void append_what_remains(TextLines& lines, const RepairReport& report, const KeyIds& ids,
                         ListLength lists) {
  const std::vector<RefusalGroup> refusals = group_refusals(report, ids);
  const DefectCodes codes = lists == ListLength::Full ? DefectCodes::all() : report.fixes;
  if (n_remaining(report, codes) == 0 && refusals.empty()) return;
  lines.heading("WHAT REMAINS, AND WHY");
  append_refusals(lines, refusals, std::nullopt, lists);
  for (std::size_t i = 0; i < report.meshes.size(); ++i) {
    const FinalMesh& mesh = report.meshes[i];
    const bool is_refused = std::any_of(refusals.begin(), refusals.end(),
                                        [&](const RefusalGroup& group) { return group.mesh == i; });
    if (!is_refused && mesh.remaining.count(codes) == 0) continue;
    if (report.meshes.size() > 1) lines.line("mesh", mesh_text(report, i));
    append_refusals(lines, refusals, i, lists);
    append_defects(lines, {mesh.name, mesh.remaining, codes}, lists);
  }
}

}  // namespace

std::string text_report(const RepairReport& report, ListLength lists) {
  const KeyIds ids(report);
  TextLines lines;
  lines.heading("REPAIR");
  append_outcome(lines, report);
  append_counts(lines, report);
  append_steps(lines, report, ids, lists);
  if (!report.result.patches.empty()) {
    lines.heading("WHAT BECAME OF SELF-INTERSECTIONS");
    append_patches(lines, {report.input, report.result.before.defects, report.result.patches},
                   lists);
  }
  append_what_remains(lines, report, ids, lists);
  return std::move(lines.text());
}

}  // namespace meshalyzer
