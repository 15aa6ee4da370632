#include "session.h"

#include "batch.h"
#include "combine.h"
#include "freed_memory.h"
#include "input_file.h"
#include "mesh_paths.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/gzip.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/report/json/repair_report.h"
#include "meshalyzer/report/text/defects_report.h"
#include "meshalyzer/report/text/repair_report.h"
#include "page.h"
#include "repair_mesh.h"
#include "stop_request.h"
#include "targets.h"
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
  const bool is_clean = report.count(requested) == 0 && !report.may_have_more(requested);
  return is_clean ? ExitCode::Done : ExitCode::NotGood;
}

ExitCode fix(const RepairTask& task, Soup soup) {
  const Options& options = task.options;
  // Standard output receives only the mesh.
  const Streams streams{options.writes_to_stdout() ? task.streams.err : task.streams.out,
                        task.streams.err};
  return repair_mesh(task, std::move(soup), [&](const RepairReport& report) {
    return write_report(
        options, streams, [&] { return text_report(report, options.lists); },
        [&] { return json_report(report); });
  });
}

/// Refuses a folder where one mesh is repaired or examined.
void require_no_folder(const Options& options) {
  if (!is_folder(options.input)) return;
  const bool is_find = options.action == Options::Action::Find;
  throw UsageError(options.input + " is a folder: " +
                   (options.output ? "name a folder as OUT too, or give --in-place in place of -o"
                    : is_find
                        ? "--find takes one mesh file; 'meshalyzer check' judges those of a folder"
                        : "--dry-run takes one mesh file"));
}

}  // namespace

ExitCode work(const Options& options, Streams streams) {
  const UnpackLimit limit(options.max_unpack_ratio);
  if (options.action == Options::Action::Combine) return combine(options, streams);
  if (options.is_batch()) return run_batch(options, streams);
  require_no_folder(options);
  RunFiles files = files_of_run(options, {options.input});
  return report_or_reason(options, streams, [&] {
    const InputFile file(options.input);
    keep_freed_memory_if_small(file.bytes().size());
    Soup soup = parse_mesh(file.bytes(), options.input);
    if (options.action == Options::Action::Find) return find(options, std::move(soup), streams);
    return fix({options, file, files, streams}, std::move(soup));
  });
}

}  // namespace meshalyzer::fixer
