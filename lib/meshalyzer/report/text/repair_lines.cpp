#include "meshalyzer/report/text/repair_lines.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/report/format_text.h"
#include "meshalyzer/report/text/short_list.h"

#include <cstdint>
#include <fmt/format.h>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

/// Appends a count, such as "2 faces removed", unless it is 0.
void append_count(std::string& text, std::size_t n, std::string_view one, std::string_view many) {
  if (n == 0) return;
  if (!text.empty()) text += ", ";
  text += counted(n, one, many);
}

bool changes_no_element(const LogStep& step) {
  return step.operations != 0 && step.faces_removed + step.faces_added + step.faces_changed == 0 &&
         step.vertices_removed + step.vertices_added + step.vertices_moved == 0;
}

void append_places(std::string& text, std::string_view one, std::string_view many,
                   const std::vector<std::int64_t>& ids, ListLength lists) {
  if (ids.empty()) return;
  text += "; ";
  text += ids.size() == 1 ? one : many;
  append_ids(text, ids, lists);
}

void append_written(LineSink& lines, const RepairReport& report) {
  bool is_written = false;
  for (const FinalMesh& mesh : report.meshes) {
    if (mesh.name.path.empty()) continue;
    lines.line("written", mesh.name.path);
    is_written = true;
  }
  if (!is_written) lines.line("written", "nothing");
}

}  // namespace

void append_distance(std::string& text, double distance) {
  if (distance == 0.0) return;
  text += ", largest move ";
  text += readable(distance);
}

std::string step_text(const LogStep& step) {
  std::string text;
  append_count(text, step.operations, "change", "changes");
  if (changes_no_element(step)) text += " of ids or normals";
  append_count(text, step.faces_removed, "face removed", "faces removed");
  append_count(text, step.faces_added, "face added", "faces added");
  append_count(text, step.faces_changed, "face changed", "faces changed");
  append_count(text, step.vertices_removed, "vertex removed", "vertices removed");
  append_count(text, step.vertices_added, "vertex added", "vertices added");
  append_count(text, step.vertices_moved, "vertex moved", "vertices moved");
  append_distance(text, step.distance);
  append_count(text, step.undone, "change undone", "changes undone");
  return text;
}

void append_refusal(LineSink& lines, const RefusalGroup& group, ListLength lists) {
  const LoggedRefusal& refusal = *group.first;
  std::string text = fmt::format("{}, {}: {}", defect_name(refusal.code),
                                 counted(group.places, "place", "places"), refusal.reason);
  append_places(text, "vertex", "vertices", group.vertices, lists);
  append_places(text, "face", "faces", group.faces, lists);
  lines.line("left by " + refusal.pass, text);
}

void append_outcome(LineSink& lines, const RepairReport& report) {
  lines.line("file", report.input.path);
  lines.line("format", format_text(report.input.path, report.input.format));
  append_written(lines, report);
  for (const std::string& note : report.notes) lines.line("note", note);
  if (!report.lost.empty()) lines.line("lost", lost_text(report.lost));
  for (const std::string& warning : report.result.before.warnings) lines.line("warning", warning);
  lines.change("vertices", report.input.n_vertices, n_final_vertices(report));
  lines.change("faces", report.input.n_faces, n_final_faces(report));
  lines.line("maximum deviation", report.result.max_deviation);
  lines.line("largest deviation", report.result.deviation);
}

std::string lost_text(const std::vector<AttributeCount>& lost) {
  std::string text;
  for (const AttributeCount& count : lost) {
    if (!text.empty()) text += ", ";
    text += attribute_text(count);
  }
  return text;
}

std::string mesh_text(const RepairReport& report, std::size_t mesh) {
  const std::string& path = report.meshes[mesh].name.path;
  return path.empty() ? std::to_string(mesh + 1) : path;
}

}  // namespace meshalyzer
