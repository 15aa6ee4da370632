#include "meshalyzer/report/text/repair_lines.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/report/format_text.h"
#include "meshalyzer/report/text/short_list.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

/// Appends `n face(s) verb`, if there are any.
void append_count(std::string& text, std::size_t n, std::string_view one, std::string_view many) {
  if (n == 0) return;
  if (!text.empty()) text += ", ";
  text += counted(n, one, many);
}

bool changes_no_element(const LogStep& step) {
  return step.operations != 0 && step.faces_removed + step.faces_added + step.faces_changed == 0 &&
         step.vertices_removed + step.vertices_added + step.vertices_moved == 0;
}

void append_places(std::string& text, std::string_view word, const std::vector<std::int64_t>& ids,
                   ListLength lists) {
  if (ids.empty()) return;
  text += "; ";
  text += word;
  for (std::size_t i = 0; i < n_shown(ids.size(), lists); ++i) {
    text += ' ';
    text += std::to_string(ids[i]);
  }
  append_rest(text, ids.size(), lists);
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

std::string arrow(std::size_t before, std::size_t after) {
  std::string text = std::to_string(before);
  text += " -> ";
  text += std::to_string(after);
  return text;
}

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
  std::string name = "left by ";
  name += group.first->pass;
  std::string text(defect_name(group.first->code));
  text += ", ";
  text += counted(group.places, "place", "places");
  text += ": ";
  text += group.first->reason;
  append_places(text, group.vertices.size() == 1 ? "vertex" : "vertices", group.vertices, lists);
  append_places(text, group.faces.size() == 1 ? "face" : "faces", group.faces, lists);
  lines.line(name, text);
}

void append_outcome(LineSink& lines, const RepairReport& report) {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (const FinalMesh& mesh : report.meshes) {
    vertices += mesh.name.n_vertices;
    faces += mesh.name.n_faces;
  }
  lines.line("file", report.input.path);
  lines.line("format", format_text(report.input.path, report.input.format));
  append_written(lines, report);
  for (const std::string& note : report.notes) lines.line("note", note);
  if (!report.lost.empty()) lines.line("lost", lost_text(report.lost));
  for (const std::string& warning : report.result.before.warnings) lines.line("warning", warning);
  lines.line("vertices", arrow(report.input.n_vertices, vertices));
  lines.line("faces", arrow(report.input.n_faces, faces));
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
