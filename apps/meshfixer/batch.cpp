#include "batch.h"

#include "batch_report.h"
#include "freed_memory.h"
#include "input_file.h"
#include "interrupt.h"
#include "mesh_paths.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/io/read.h"
#include "repair_mesh.h"
#include "targets.h"

#include <algorithm>
#include <new>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer::fixer {
namespace {

/// What the repairs of the files have in common.
struct BatchRun {
  const Options& options;
  RunFiles& files;
  BatchReport& report;
  Streams streams;
};

/// Reports a file that cannot be repaired; the others are.
ExitCode fail(const BatchRun& run, const std::string& file, const std::string& why) {
  run.streams.err << why << std::endl;
  run.report.add_error(file, why);
  return ExitCode::Failure;
}

ExitCode repair_one(const BatchRun& run, const std::string& file) {
  Options options = run.options;
  options.input = file;
  options.output = result_path(run.options, file);
  try {
    const InputFile input(file);
    require_format(*options.output);
    keep_freed_memory_if_small(input.bytes().size());
    Soup soup = parse_mesh(input.bytes(), file);
    const RepairTask task{options, input, run.files, run.streams};
    return repair_mesh(task, std::move(soup), [&](const RepairReport& repair) {
      run.report.add(file, repair);
      return ExitCode::Done;
    });
  } catch (const Error& error) {
    return fail(run, file, error.what());
  } catch (const std::bad_alloc&) {
    return fail(run, file, file + ": not enough memory");
  }
}

}  // namespace

ExitCode run_batch(const Options& options, Streams streams) {
  const MeshPaths batch = find_meshes(options.paths);
  RunFiles files = files_of_run(options, batch.files);
  make_output_folder(options);
  BatchReport report(options, streams);
  ExitCode worst = ExitCode::Done;
  for (const std::string& error : batch.errors) {
    streams.err << error << std::endl;
    worst = ExitCode::Failure;
  }
  const BatchRun run{options, files, report, streams};
  for (const std::string& file : batch.files) {
    worst = std::max(worst, repair_one(run, file));
    if (InterruptGuard::is_interrupted()) {
      worst = ExitCode::Interrupted;
      break;
    }
  }
  report.finish();
  if (streams.out) return worst;
  streams.err << "meshfixer: standard output: cannot be written\n";
  return ExitCode::Failure;
}

}  // namespace meshalyzer::fixer
