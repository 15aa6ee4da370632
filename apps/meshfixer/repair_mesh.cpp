#include "repair_mesh.h"

#include "judge_file.h"
#include "meshalyzer/analysis/goodness.h"
#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/io/format_of.h"
#include "output.h"
#include "page.h"
#include "progress_line.h"
#include "stop_request.h"

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer::fixer {
namespace {

constexpr const char* kNothingLeft = "nothing is left that the format can hold";

/// Tells whether two soups have the same records, apart from their notation in the file.
bool is_same_mesh(const Soup& a, const Soup& b) {
  return a.positions == b.positions && a.triangles == b.triangles && a.normals == b.normals &&
         a.corner_normals == b.corner_normals && a.torn_lines.size() == b.torn_lines.size();
}

/// Tells whether two soups are the same apart from the order of their faces.
/// @param faces  The face of `a` for each face of `b`; empty if the order is the same.
bool is_same_but_for_order(const Soup& a, const Soup& b, const std::vector<Index>& faces) {
  if (a.positions != b.positions || a.normals != b.normals || a.n_faces() != b.n_faces() ||
      a.corner_normals.size() != b.corner_normals.size() || a.format != b.format ||
      faces.size() != b.n_faces()) {
    return false;
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (a.triangles[faces[f]] != b.triangles[f] ||
        (!b.corner_normals.empty() && a.corner_normals[faces[f]] != b.corner_normals[f])) {
      return false;
    }
  }
  return true;
}

/// Returns the options of the final search: all defects, with the tolerances and limits of the
/// input.
DefectOptions final_search(const Options& options, const RepairReport& report) {
  return {.codes = DefectCodes::all(),
          .tolerances = as_options(report.result.before.tolerances),
          .max_defects = options.repair.max_defects,
          .pairs = pair_limits(options.repair, report.input.n_faces)};
}

/// Returns the defects that remain in the mesh on disk: those that the repair found, unless the
/// file differs from the mesh in memory. If the mesh has no defects, its faces may be in another
/// order.
///
/// @param face_records  See Output::face_records.
/// @param final_soup    Receives the prepared form of the mesh on disk, if there is one.
DefectReport remaining_on_disk(const RepairedMesh& mesh, const std::vector<Index>& face_records,
                               const DefectOptions& search, FinalSoup& final_soup) {
  const Soup& disk = *final_soup.soup;
  const bool is_same = is_same_mesh(disk, mesh.tracked.soup);
  if (is_same) final_soup.prepared = mesh.prepared;
  const bool is_in_other_order = is_same_but_for_order(disk, mesh.tracked.soup, face_records);
  if (mesh.remaining.total() == 0 && is_in_other_order) return mesh.remaining;
  const bool has_numbers = disk.format == Format::Mesh;
  if (is_same && has_numbers == (mesh.tracked.soup.format == Format::Mesh)) {
    return mesh.remaining;
  }
  const auto prepared = std::make_shared<PreparedMesh>(final_soup.soup, search.pairs);
  // The positions are the same, so that no faces intersect in the file either.
  if (is_in_other_order && mesh.remaining.count(DefectCode::SelfIntersection) == 0 &&
      !mesh.remaining.may_have_more({DefectCode::SelfIntersection})) {
    prepared->set_intersecting_pairs({});
  }
  final_soup.prepared = prepared;
  return find_defects(*prepared, search);
}

/// Tells whether a result is the input as it was read.
bool is_unchanged(const RepairReport& report) {
  if (report.result.meshes.size() != 1 || !report.result.log.steps.empty()) return false;
  const Soup& soup = report.result.meshes.front().tracked.soup;
  return soup.n_vertices() == report.input.n_vertices && soup.n_faces() == report.input.n_faces;
}

/// The current file, and the destination of its result.
struct Job {
  const Options& options;
  Source source;
  RunFiles& files;
  Streams streams;
};

/// Returns the paths of the meshes of a result, and adds those of components to the files of the
/// run.
std::vector<std::string> output_paths(const Job& job, const RepairReport& report) {
  const Options& options = job.options;
  // Standard output has the format of the input.
  if (options.writes_to_stdout()) {
    const std::string gzip = job.source.file.plain().was_gzipped() ? ".gz" : "";
    return {name_of_stdout(report.input.format) + gzip};
  }
  if (!report.fixes.contains(DefectCode::Disjoint)) return {*options.output};
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < report.result.meshes.size(); ++i) {
    paths.push_back(numbered_path(*options.output, i + 1));
    job.files.add_output(paths.back(), "component " + std::to_string(i + 1));
  }
  return paths;
}

/// Writes one mesh to its destination.
/// @return The mesh as read back.
Soup put(const Job& job, const Output& output, bool is_changed, const std::string& path) {
  if (job.options.writes_to_stdout()) return write_to_stdout(output, path, job.streams.out);
  if (job.options.target == Options::Target::InPlace && !is_changed) return job.source.soup;
  return write_output(output, path, job.options.backup);
}

/// Returns a mesh that is not written to disk.
FinalSoup unwritten(const RepairedMesh& mesh) {
  return {std::make_shared<const Soup>(mesh.tracked.soup), mesh.prepared};
}

/// Tells whether the resulting meshes are needed after they are written.
bool keeps_meshes(const Options& options) {
  return options.html || options.repair.guarantee;
}

/// Writes the meshes of a result, reads them back, and adds what they are to the report.
/// @return The meshes of the report, if they are needed again.
std::vector<FinalSoup> write_all(const Job& job, const std::vector<std::string>& paths,
                                 RepairReport& report) {
  const Options& options = job.options;
  std::vector<FinalSoup> finals;
  std::vector<Loss> losses;
  const DefectOptions search = final_search(options, report);
  const bool is_changed = !is_unchanged(report);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const RepairedMesh& mesh = report.result.meshes[i];
    if (!has_content(mesh.tracked.soup, paths[i])) {
      report.notes.push_back(kNothingLeft);
      report.meshes.push_back({name_of(mesh.tracked.soup, ""), mesh.remaining});
      if (keeps_meshes(options)) finals.push_back(unwritten(mesh));
      continue;
    }
    Output output = make_output(mesh.tracked, is_changed, paths[i], job.source);
    FinalSoup disk{std::make_shared<const Soup>(put(job, output, is_changed, paths[i])), nullptr};
    if (!output.note.empty()) report.notes.push_back(output.note);
    losses.push_back(std::move(output.loss));
    report.meshes.push_back({name_of(*disk.soup, options.writes_to_stdout() ? "-" : paths[i]),
                             remaining_on_disk(mesh, output.face_records, search, disk),
                             vertex_records(mesh.tracked.soup, *disk.soup, output.face_records),
                             std::move(output.face_records)});
    if (keeps_meshes(options)) finals.push_back(std::move(disk));
  }
  report.lost = lost_by_all(losses, job.source);
  return finals;
}

/// Reports the attributes that would be lost, if none may be.
/// @return True if there are any.
bool refuses_loss(const Job& job, const std::vector<std::string>& paths, RepairReport& report) {
  if (job.options.loss == Options::Loss::Tell) return false;
  std::vector<Loss> losses;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const TrackedMesh& mesh = report.result.meshes[i].tracked;
    if (!has_content(mesh.soup, paths[i])) continue;
    losses.push_back(make_output(mesh, !is_unchanged(report), paths[i], job.source).loss);
  }
  report.lost = lost_by_all(losses, job.source);
  if (!report.lost.empty()) {
    report.notes.emplace_back("nothing is written, because attributes would be lost");
  }
  return !report.lost.empty();
}

/// Takes the resulting meshes without writing them.
std::vector<FinalSoup> take_unwritten(const Options& options, RepairReport& report) {
  std::vector<FinalSoup> finals;
  for (const RepairedMesh& mesh : report.result.meshes) {
    report.meshes.push_back({name_of(mesh.tracked.soup, ""), mesh.remaining});
    if (keeps_meshes(options)) finals.push_back(unwritten(mesh));
  }
  return finals;
}

/// Adds the resulting meshes to the report, and writes them if they are to be written.
std::vector<FinalSoup> take_or_write(const Job& job, RepairReport& report) {
  if (job.options.output) {
    const std::vector<std::string> paths = output_paths(job, report);
    if (!refuses_loss(job, paths, report)) return write_all(job, paths, report);
  }
  return take_unwritten(job.options, report);
}

/// Tells whether all meshes are good by the analysis of the files on disk; notes the reasons if
/// not.
bool are_good(const std::vector<FinalSoup>& finals, RepairReport& report) {
  bool is_good = true;
  for (std::size_t i = 0; i < finals.size(); ++i) {
    const Goodness fitness = judge_file(*finals[i].soup, report.meshes[i].name.path);
    if (fitness.good) continue;
    is_good = false;
    report.notes.push_back("verdict: " + verdict_text(fitness));
  }
  return is_good;
}

/// Returns Done or NotGood, or Failure if a mesh should have been written and was not.
ExitCode verdict(const Options& options, const RepairReport& report, Streams streams) {
  const bool is_missing =
      report.meshes.empty() || std::any_of(report.meshes.begin(), report.meshes.end(),
                                           [](const FinalMesh& m) { return m.name.path.empty(); });
  if (options.loss == Options::Loss::Refuse && !report.lost.empty()) return ExitCode::NotGood;
  if (options.output && is_missing) {
    streams.err << without_controls(*options.output) << ": not written: " << kNothingLeft << '\n';
    return ExitCode::Failure;
  }
  return nothing_remains(report) ? ExitCode::Done : ExitCode::NotGood;
}

std::string progress_text(const RepairProgress& now) {
  return std::string(now.pass) + ", round " + std::to_string(now.round) + ", " +
         std::to_string(static_cast<int>(100.0 * now.done)) + " %";
}

}  // namespace

ExitCode repair_mesh(const RepairTask& task, Soup soup,
                     const std::function<ExitCode(const RepairReport&)>& on_report) {
  const Options& options = task.options;
  const Streams streams = task.streams;
  const MeshName input = name_of(soup, options.input);
  ProgressLine progress(streams.err, options.progress == ReportOptions::Progress::Never
                                         ? ProgressLine::State::Off
                                         : terminal_state(streams.err));
  RepairOptions repair = options.repair;
  repair.on_progress = [&](const RepairProgress& now) { progress.show(progress_text(now)); };
  const StopRequest stop(options.time_limit);
  repair.wants_to_stop = [&] { return stop.is_made(); };
  repair.reports_patches = !options.output;
  if (options.output && !options.writes_to_stdout()) {
    repair.written_as =
        options.target == Options::Target::InPlace ? soup.format : format_of_name(*options.output);
  }
  DrawnInput before;
  if (options.html) {
    repair.keep_prepared = true;
    repair.on_input = [&](std::shared_ptr<const PreparedMesh> mesh, const DefectReport& defects) {
      before = {mesh, scene_of(*mesh, defects)};
    };
  }
  const Soup input_soup = options.output ? soup : Soup();
  const RepairResult result = fix_defects(std::move(soup), repair);
  progress.clear();
  RepairReport report{input, result, repair.fixes, {}, {}};
  report.notes = result.notes;
  if (result.is_stopped) report.notes.push_back(StopRequest::note());
  const std::vector<FinalSoup> finals =
      take_or_write({options, {task.file, input_soup}, task.files, streams}, report);
  const bool is_as_guaranteed = !options.repair.guarantee || are_good(finals, report);
  if (options.html) write_page(*options.html, report, std::move(before), finals);
  const ExitCode status = on_report(report);
  if (status != ExitCode::Done) return status;
  const ExitCode code = verdict(options, report, streams);
  return code == ExitCode::Done && !is_as_guaranteed ? ExitCode::NotGood : code;
}

}  // namespace meshalyzer::fixer
