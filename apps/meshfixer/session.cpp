#include "session.h"

#include "batch.h"
#include "combine.h"
#include "input_file.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/gzip.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/report/json/repair_report.h"
#include "meshalyzer/report/text/defects_report.h"
#include "meshalyzer/report/text/repair_report.h"
#include "page.h"
#include "repair_mesh.h"
#include "same_file.h"
#include "stop_request.h"
#include "usage_error.h"
#include "write_report.h"

#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer::fixer {
namespace {

/// Returns the outcome of a repair for each self-intersection, if they are to be fixed.
std::vector<PatchOutcome> find_outcomes(RepairOptions repair, Soup soup,
                                        const DefectReport& found) {
  constexpr DefectCode kCode = DefectCode::SelfIntersection;
  if (found.count(kCode) == 0 || !repair.fixes.contains(kCode)) return {};
  repair.reports_patches = true;
  return fix_defects(std::move(soup), repair).patches;
}

ExitCode find(const Options& options, Soup soup, Streams streams) {
  const StopRequest stop(options.time_limit);
  RepairOptions repair = options.repair;
  repair.wants_to_stop = [&] { return stop.is_made(); };
  std::optional<PreparedMesh> mesh(std::in_place, soup, pair_limits(repair, soup.n_faces()));
  DefectOptions find_all;
  find_all.tolerances = repair.tolerances;
  find_all.max_defects = repair.max_defects;
  find_all.wants_to_stop = repair.wants_to_stop;
  const DefectReport report = find_defects(*mesh, find_all);
  const MeshName name = name_of(soup, options.input);
  const DefectCodes& requested = options.repair.fixes;
  const Scene scene = options.html ? scene_of(*mesh, report) : Scene{};
  mesh.reset();
  const std::vector<PatchOutcome> patches = find_outcomes(repair, std::move(soup), report);
  if (options.html) write_page(*options.html, {name, report, requested, scene, patches});
  const FoundDefects found{name, report, requested, patches};
  const ExitCode status = write_report(
      options, streams, [&] { return text_report(found, options.lists); },
      [&] { return json_report(found); });
  if (status != ExitCode::Done) return status;
  return report.count(requested) == 0 ? ExitCode::Done : ExitCode::NotGood;
}

ExitCode fix(const Options& options, Soup soup, const InputFile& file, Streams streams) {
  return repair_mesh(options, std::move(soup), file, streams, [&](const RepairReport& report) {
    // Standard output receives only the mesh.
    const Streams streams_of_report{options.writes_to_stdout() ? streams.err : streams.out,
                                    streams.err};
    return write_report(
        options, streams_of_report, [&] { return text_report(report, options.lists); },
        [&] { return json_report(report); });
  });
}

/// Rejects a report that would overwrite the input or OUT.
void check_report(const Options& options, const std::string& file, const std::string& option) {
  if (is_same_file(options.input, file)) {
    throw UsageError("the FILE of " + option + " is the input itself, which never changes");
  }
  if (options.output && is_same_file(*options.output, file)) {
    throw UsageError("the FILE of " + option + " is OUT");
  }
}

/// Rejects outputs that would overwrite the input or each other.
void check_outputs(const Options& options) {
  if (options.output && !options.writes_to_stdout() &&
      is_same_file(options.input, *options.output)) {
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
  const UnpackLimit limit(options.max_unpack_ratio);
  if (options.action == Options::Action::Combine) return combine(options, streams);
  if (options.is_batch()) return run_batch(options, streams);
  check_outputs(options);
  const InputFile file(options.input);
  Soup soup = parse_mesh(file.bytes(), options.input);
  if (options.action == Options::Action::Find) return find(options, std::move(soup), streams);
  return fix(options, std::move(soup), file, streams);
}

}  // namespace meshalyzer::fixer
