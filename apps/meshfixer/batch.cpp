#include "batch.h"

#include "batch_report.h"
#include "input_file.h"
#include "interrupt.h"
#include "mesh_folder.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/read.h"
#include "repair_mesh.h"
#include "same_file.h"
#include "usage_error.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace meshalyzer::fixer {
namespace {

/// A file and the destination of its result.
struct BatchFile {
  std::string input;
  std::string output;
};

/// The files that the paths stand for, in their order.
struct BatchFiles {
  std::vector<BatchFile> files;
  /// The paths that could not be listed or held no mesh, with the reason.
  std::vector<std::string> errors;
};

std::string output_for(const Options& options, const std::string& input) {
  if (options.target == Options::Target::InPlace) return input;
  const std::filesystem::path name = std::filesystem::path(input).filename();
  return (std::filesystem::path(*options.output) / name).string();
}

void add_file(const Options& options, const std::string& input, BatchFiles& batch) {
  if (input == "-") {
    throw UsageError("standard input has no name: name OUT as one mesh file");
  }
  batch.files.push_back({input, output_for(options, input)});
}

BatchFiles find_files(const Options& options) {
  BatchFiles batch;
  for (const std::string& path : options.paths) {
    if (!is_folder(path)) {
      add_file(options, path, batch);
      continue;
    }
    MeshFolder folder = list_mesh_folder(path);
    for (const std::string& file : folder.files) add_file(options, file, batch);
    if (!folder.error.empty()) batch.errors.push_back(std::move(folder.error));
  }
  return batch;
}

/// Rejects an output that would overwrite another one, or an input that must not change.
void check_outputs(const Options& options, const BatchFiles& batch) {
  std::map<std::string, std::string> inputs;
  std::vector<std::string> paths;
  for (const BatchFile& file : batch.files) {
    const auto [other, is_new] = inputs.emplace(file.output, file.input);
    if (!is_new) {
      throw UsageError(other->second + " and " + file.input + " would both be written to " +
                       file.output);
    }
    paths.push_back(file.input);
  }
  const KnownFiles known(paths);
  const auto check = [&](const std::string& path) {
    if (known.contain(path)) {
      throw UsageError(path + " would be written, but it is an input, which never changes");
    }
  };
  if (options.target == Options::Target::Folder) {
    for (const BatchFile& file : batch.files) check(file.output);
  }
  for (const auto* report : {&options.json, &options.ndjson}) {
    if (*report && !(*report)->is_stdout()) check((*report)->file);
  }
}

void make_folder(const Options& options) {
  if (options.target != Options::Target::Folder) return;
  std::error_code error;
  std::filesystem::create_directories(*options.output, error);
  if (error) throw IoError(*options.output, {}, "cannot be made a folder: " + error.message());
}

ExitCode repair_one(const Options& options, const BatchFile& file, Streams streams,
                    BatchReport& report) {
  Options of_file = options;
  of_file.input = file.input;
  of_file.output = file.output;
  try {
    if (!format_of_name(file.output)) {
      throw IoError(file.output, {},
                    std::string("has the ending of no known mesh format (") + kMeshEndings + ")");
    }
    const InputFile input(file.input);
    Soup soup = parse_mesh(input.bytes(), file.input);
    return repair_mesh(of_file, std::move(soup), input, streams, [&](const RepairReport& repair) {
      report.add(file.input, repair);
      return ExitCode::Done;
    });
  } catch (const Error& error) {
    streams.err << error.what() << std::endl;
    report.add_error(file.input, error.what());
    return ExitCode::Failure;
  }
}

}  // namespace

ExitCode run_batch(const Options& options, Streams streams) {
  const BatchFiles batch = find_files(options);
  check_outputs(options, batch);
  make_folder(options);
  BatchReport report(options, streams);
  ExitCode worst = ExitCode::Done;
  for (const std::string& error : batch.errors) {
    streams.err << error << std::endl;
    worst = ExitCode::Failure;
  }
  for (const BatchFile& file : batch.files) {
    worst = std::max(worst, repair_one(options, file, streams, report));
    if (InterruptGuard::is_interrupted()) {
      worst = ExitCode::Interrupted;
      break;
    }
  }
  report.finish();
  if (streams.out) return worst;
  streams.err << "meshfixer: standard output takes no more\n";
  return ExitCode::Failure;
}

}  // namespace meshalyzer::fixer
