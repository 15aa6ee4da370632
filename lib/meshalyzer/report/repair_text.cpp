#include "meshalyzer/report/repair_text.h"

#include "meshalyzer/report/defect_lines.h"
#include "meshalyzer/report/key_ids.h"
#include "meshalyzer/report/refusal_groups.h"
#include "meshalyzer/report/short_list.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

std::string arrow(std::size_t before, std::size_t after) {
  std::string text = std::to_string(before);
  text += " -> ";
  text += std::to_string(after);
  return text;
}

/// Appends `n face(s) verb`, where there are any.
void append_count(std::string& text, std::size_t n, std::string_view one, std::string_view many) {
  if (n == 0) return;
  if (!text.empty()) text += ", ";
  text += counted(n, one, many);
}

void append_distance(std::string& text, double distance) {
  if (distance == 0.0) return;
  text += ", largest move ";
  text += readable(distance);
}

bool changes_no_element(const LogStep& step) {
  return step.operations != 0 && step.faces_removed + step.faces_added + step.faces_changed == 0 &&
         step.vertices_removed + step.vertices_added + step.vertices_moved == 0;
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

void append_ids(std::string& text, std::string_view what, const std::vector<std::int64_t>& ids) {
  if (ids.empty()) return;
  text += ", ";
  text += what;
  for (const std::int64_t id : ids) {
    text += ' ';
    text += std::to_string(id);
  }
}

std::string operation_text(const LoggedOperation& operation, const KeyIds& ids) {
  std::string text;
  append_ids(text, "removed faces", ids.faces(operation.removed_faces));
  append_ids(text, "added faces", ids.faces(operation.added_faces));
  append_ids(text, "changed faces", ids.faces(operation.changed_faces));
  append_ids(text, "removed vertices", ids.vertices(operation.removed_vertices));
  append_ids(text, "added vertices", ids.vertices(operation.added_vertices));
  append_ids(text, "moved vertices", ids.vertices(operation.moved_vertices));
  append_distance(text, operation.distance);
  return text.empty() ? ", ids or normals only" : text;
}

void append_steps(TextLines& lines, const RepairStory& story, const KeyIds& ids, ListLength lists) {
  lines.heading("WHAT WAS DONE");
  const RepairLog& log = story.result.log;
  if (log.steps.empty()) lines.line("changes", "none");
  auto next = log.operations.begin();
  for (std::size_t i = 0; i < log.steps.size(); ++i) {
    lines.line(log.steps[i].pass, step_text(log.steps[i]));
    for (; next != log.operations.end() && next->step == i; ++next) {
      if (lists == ListLength::Short) continue;
      std::string change = log.steps[i].pass;
      change += operation_text(*next, ids);
      lines.line("change", change);
    }
  }
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

void append_refusal(TextLines& lines, const RefusalGroup& group, ListLength lists) {
  std::string name = "left by ";
  name += group.like->pass;
  std::string text(defect_name(group.like->code));
  text += ", ";
  text += counted(group.places, "place", "places");
  text += ": ";
  text += group.like->reason;
  append_places(text, group.vertices.size() == 1 ? "vertex" : "vertices", group.vertices, lists);
  append_places(text, group.faces.size() == 1 ? "face" : "faces", group.faces, lists);
  lines.line(name, text);
}

/// What was left in one of the meshes, or, where none is named, in parts that are gone.
void append_refusals(TextLines& lines, const std::vector<RefusalGroup>& groups,
                     std::optional<std::size_t> mesh, ListLength lists) {
  for (const RefusalGroup& group : groups) {
    if (group.mesh == mesh) append_refusal(lines, group, lists);
  }
}

void append_counts(TextLines& lines, const RepairStory& story) {
  lines.heading("DEFECTS BEFORE AND AFTER");
  std::size_t before = 0;
  std::size_t after = 0;
  for (const DefectCode code : all_defect_codes()) {
    std::size_t left = 0;
    for (const FinalMesh& mesh : story.meshes) left += mesh.remaining.count(code);
    std::string text = arrow(story.result.before.count(code), left);
    if (!story.fixes.contains(code) && left != 0) text += " (not asked for)";
    lines.line(defect_name(code), text);
    before += story.result.before.count(code);
    after += left;
  }
  lines.line("defects", arrow(before, after));
  lines.line("asked for and left", n_remaining(story));
}

void append_written(TextLines& lines, const RepairStory& story) {
  bool is_written = false;
  for (const FinalMesh& mesh : story.meshes) {
    if (mesh.name.path.empty()) continue;
    lines.line("written", mesh.name.path);
    is_written = true;
  }
  if (!is_written) lines.line("written", "nothing");
}

void append_what_came_out(TextLines& lines, const RepairStory& story) {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (const FinalMesh& mesh : story.meshes) {
    vertices += mesh.name.n_vertices;
    faces += mesh.name.n_faces;
  }
  lines.heading("REPAIR");
  lines.line("file", story.input.path);
  lines.line("format", format_name(story.input.format));
  append_written(lines, story);
  for (const std::string& note : story.notes) lines.line("note", note);
  for (const std::string& warning : story.result.before.warnings) lines.line("warning", warning);
  lines.line("vertices", arrow(story.input.n_vertices, vertices));
  lines.line("faces", arrow(story.input.n_faces, faces));
  lines.line("maximum deviation", story.result.max_deviation);
  lines.line("largest deviation", story.result.deviation);
}

/// The path of one of several meshes, or, where none was written, its number.
std::string mesh_text(const RepairStory& story, std::size_t mesh) {
  const std::string& path = story.meshes[mesh].name.path;
  return path.empty() ? std::to_string(mesh + 1) : path;
}

/// Short: only what was asked for; of the rest the counts have told.
void append_what_remains(TextLines& lines, const RepairStory& story, const KeyIds& ids,
                         ListLength lists) {
  const std::vector<RefusalGroup> refusals = group_refusals(story, ids);
  const DefectCodes codes = lists == ListLength::Full ? DefectCodes::all() : story.fixes;
  std::size_t n = 0;
  for (const FinalMesh& mesh : story.meshes) n += n_asked(mesh.remaining, codes);
  if (n == 0 && refusals.empty()) return;
  lines.heading("WHAT REMAINS, AND WHY");
  append_refusals(lines, refusals, std::nullopt, lists);
  for (std::size_t i = 0; i < story.meshes.size(); ++i) {
    const FinalMesh& mesh = story.meshes[i];
    const bool is_refused = std::any_of(refusals.begin(), refusals.end(),
                                        [&](const RefusalGroup& group) { return group.mesh == i; });
    if (!is_refused && n_asked(mesh.remaining, codes) == 0) continue;
    if (story.meshes.size() > 1) lines.line("mesh", mesh_text(story, i));
    append_refusals(lines, refusals, i, lists);
    append_defects(lines, {mesh.name, mesh.remaining, codes}, lists);
  }
}

}  // namespace

std::string repair_report(const RepairStory& story, ListLength lists) {
  const KeyIds ids(story);
  TextLines lines;
  append_what_came_out(lines, story);
  append_counts(lines, story);
  append_steps(lines, story, ids, lists);
  append_what_remains(lines, story, ids, lists);
  return std::move(lines.text());
}

}  // namespace meshalyzer
