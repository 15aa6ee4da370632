#include "session.h"

#include "meshalyzer/io/file.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/report/json/repair_report.h"
#include "meshalyzer/report/text/defects_report.h"
#include "meshalyzer/report/text/repair_report.h"
#include "output.h"
#include "page.h"
#include "progress_line.h"
#include "same_file.h"
#include "stop_request.h"
#include "usage_error.h"

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer::fixer {
namespace {

constexpr const char* kNothingLeft = "nothing is left that the format can hold";

/// Tells a report as text and JSON, where each is asked for.
template <typename Text, typename Json>
ExitCode tell(const Options& options, Streams streams, Text text, Json json) {
  if (options.json && !options.json->is_stdout()) replace_file(options.json->file, json());
  streams.out << (options.json && options.json->is_stdout() ? json() : text()) << std::flush;
  if (streams.out) return ExitCode::Done;
  streams.err << "meshfixer: standard output takes no more\n";
  return ExitCode::Trouble;
}

ExitCode find(const Options& options, const Soup& soup, Streams streams) {
  std::optional<PreparedMesh> mesh(std::in_place, soup);
  const DefectReport report = find_defects(*mesh, {.codes = DefectCodes::all(),
                                                   .tolerances = options.repair.tolerances,
                                                   .max_defects = options.repair.max_defects});
  const MeshName name = name_of(soup, options.input);
  const DefectCodes& asked = options.repair.fixes;
  if (options.html) write_page(*options.html, {*mesh, name, report, asked});
  mesh.reset();
  const ExitCode told = tell(
      options, streams, [&] { return text_report(name, report, asked, options.lists); },
      [&] { return json_report(name, report, asked); });
  if (told != ExitCode::Done) return told;
  return n_asked(report, asked) == 0 ? ExitCode::Done : ExitCode::NotGood;
}

/// Whether two soups are the same records, but for how the file says them.
bool is_same_mesh(const Soup& a, const Soup& b) {
  return a.positions == b.positions && a.triangles == b.triangles && a.normals == b.normals &&
         a.corner_normals == b.corner_normals && a.torn_lines.size() == b.torn_lines.size();
}

/// Returns what is looked for in the end: all defects, by the tolerances of the input.
DefectOptions final_search(const Options& options, const Tolerances& used) {
  return {.codes = DefectCodes::all(),
          .tolerances = as_options(used),
          .max_defects = options.repair.max_defects};
}

/// Returns the defects that remain in the mesh on disk: those that the repair found, unless the
/// file differs by a bit from the mesh in memory.
DefectReport remaining_on_disk(const RepairedMesh& mesh, const Soup& disk,
                               const DefectOptions& search) {
  const bool has_numbers = disk.format == Format::Mesh;
  if (is_same_mesh(disk, mesh.tracked.soup) &&
      has_numbers == (mesh.tracked.soup.format == Format::Mesh)) {
    return mesh.remaining;
  }
  return find_defects(disk, search);
}

/// Whether a result is the input as it was read.
bool is_unchanged(const RepairReport& report) {
  if (report.result.meshes.size() != 1 || !report.result.log.steps.empty()) return false;
  const Soup& soup = report.result.meshes.front().tracked.soup;
  return soup.n_vertices() == report.input.n_vertices && soup.n_faces() == report.input.n_faces;
}

/// The paths of the meshes of a result, none of which is the input.
std::vector<std::string> output_paths(const Options& options, const RepairReport& report) {
  if (!report.fixes.contains(DefectCode::Disjoint)) return {*options.output};
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < report.result.meshes.size(); ++i) {
    paths.push_back(numbered_path(*options.output, i + 1));
    if (is_same_file(options.input, paths.back())) {
      throw UsageError(paths.back() +
                       " would be written, but it is the input, which never changes");
    }
  }
  return paths;
}

/// Writes the meshes of a result, reads them back, and adds what they are to the report.
/// @return The meshes of the report as they are, where there will be a page of them.
std::vector<Soup> write_all(const Options& options, const Source& source, RepairReport& report) {
  std::vector<Soup> finals;
  const std::vector<std::string> paths = output_paths(options, report);
  const DefectOptions search = final_search(options, report.result.before.tolerances);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const RepairedMesh& mesh = report.result.meshes[i];
    if (!has_content(mesh.tracked.soup, paths[i])) {
      report.notes.push_back(kNothingLeft);
      report.meshes.push_back({name_of(mesh.tracked.soup, ""), mesh.remaining});
      if (options.html) finals.push_back(mesh.tracked.soup);
      continue;
    }
    Written written = is_unchanged(report) && keeps_format(paths[i], source)
                          ? write_unchanged(paths[i], source)
                          : write_result(mesh.tracked.soup, paths[i], source);
    if (!written.note.empty()) report.notes.push_back(written.note);
    report.meshes.push_back({name_of(written.soup, paths[i]),
                             remaining_on_disk(mesh, written.soup, search),
                             vertex_records(mesh.tracked.soup, written.soup)});
    if (options.html) finals.push_back(std::move(written.soup));
  }
  return finals;
}

/// The same for what is not to be written.
std::vector<Soup> take_unwritten(const Options& options, RepairReport& report) {
  std::vector<Soup> finals;
  for (const RepairedMesh& mesh : report.result.meshes) {
    report.meshes.push_back({name_of(mesh.tracked.soup, ""), mesh.remaining});
    if (options.html) finals.push_back(mesh.tracked.soup);
  }
  return finals;
}

/// Done or NotGood; Trouble where a mesh should have been written and was not.
ExitCode verdict(const Options& options, const RepairReport& report, Streams streams) {
  const bool is_missing =
      report.meshes.empty() || std::any_of(report.meshes.begin(), report.meshes.end(),
                                           [](const FinalMesh& m) { return m.name.path.empty(); });
  if (options.output && is_missing) {
    streams.err << *options.output << ": not written: " << kNothingLeft << '\n';
    return ExitCode::Trouble;
  }
  return n_remaining(report) == 0 ? ExitCode::Done : ExitCode::NotGood;
}

std::string progress_text(const RepairProgress& now) {
  return std::string(now.pass) + ", round " + std::to_string(now.round) + ", " +
         std::to_string(static_cast<int>(100.0 * now.done)) + " %";
}

ExitCode fix(const Options& options, Soup soup, const Source& source, Streams streams) {
  const MeshName input = name_of(soup, options.input);
  ProgressLine progress(streams.err, options.progress == ReportOptions::Progress::Never
                                         ? ProgressLine::State::Off
                                         : terminal_state(streams.err));
  RepairOptions repair = options.repair;
  repair.on_progress = [&](const RepairProgress& now) { progress.show(progress_text(now)); };
  const StopRequest stop(options.time_limit);
  repair.wants_to_stop = [&] { return stop.is_made(); };
  if (options.output) repair.written_as = format_of_name(*options.output);
  const Soup before = options.html ? soup : Soup();
  const RepairResult result = fix_defects(std::move(soup), repair);
  progress.clear();
  RepairReport report{input, result, repair.fixes, {}, {}};
  if (result.is_stopped) report.notes.push_back(StopRequest::note());
  const std::vector<Soup> finals =
      options.output ? write_all(options, source, report) : take_unwritten(options, report);
  if (options.html) write_page(*options.html, report, before, finals);
  const ExitCode told = tell(
      options, streams, [&] { return text_report(report, options.lists); },
      [&] { return json_report(report); });
  return told == ExitCode::Done ? verdict(options, report, streams) : told;
}

/// Refuses to write a report over the input, or over OUT.
void check_report(const Options& options, const std::string& file, const std::string& option) {
  if (is_same_file(options.input, file)) {
    throw UsageError("the FILE of " + option + " is the input itself, which never changes");
  }
  if (options.output && is_same_file(*options.output, file)) {
    throw UsageError("the FILE of " + option + " is OUT");
  }
}

/// Refuses to write over the input, or one output over the other.
void check_outputs(const Options& options) {
  if (options.output && is_same_file(options.input, *options.output)) {
    throw UsageError("OUT is the input itself, which never changes");
  }
  const bool has_json_file = options.json && !options.json->is_stdout();
  if (has_json_file) check_report(options, options.json->file, "--json");
  if (options.html) check_report(options, *options.html, "--html");
  if (has_json_file && options.html && is_same_file(options.json->file, *options.html)) {
    throw UsageError("the FILE of --html is that of --json");
  }
}

}  // namespace

ExitCode work(const Options& options, Streams streams) {
  check_outputs(options);
  const FileContent content(options.input);
  Soup soup = parse_mesh(content.bytes(), options.input);
  if (options.action == Options::Action::Find) return find(options, soup, streams);
  const Source source{content.bytes(), soup.format};
  return fix(options, std::move(soup), source, streams);
}

}  // namespace meshalyzer::fixer
