#include "inputs.h"

#include "mesh_paths.h"
#include "meshalyzer/set/set_files.h"
#include "request.h"
#include "usage_error.h"

#include <algorithm>
#include <set>
#include <utility>

namespace meshalyzer {
namespace {

Inputs find_inputs(const std::vector<std::string>& paths) {
  MeshPaths found = find_meshes(paths);
  Inputs inputs;
  inputs.files = std::move(found.files);
  inputs.errors = std::move(found.errors);
  inputs.is_set = found.has_folder;
  return inputs;
}

/// Throws if folders are used in a wrong way that only the paths themselves reveal.
void check_folders(const Options& options) {
  if (!options.total_volume) {
    return;
  }
  for (const std::string& path : options.paths) {
    if (!is_folder(path)) {
      throw UsageError("-v needs a folder, and " + path + " is none");
    }
  }
}

bool has_stdin(const std::vector<std::string>& paths) {
  return std::find(paths.begin(), paths.end(), "-") != paths.end();
}

/// Decides whether the files are a set: several files are one too if their relations are requested.
void decide_set(const Options& options, Inputs& inputs) {
  if (options.questions.any() && options.paths.size() > 1) {
    inputs.is_set = true;
  }
  if (options.questions.any() && !inputs.is_set) {
    throw UsageError("-i and -s need a folder, or several files");
  }
  const bool shows_separation = options.field_export.field == FieldName::Separation;
  if (shows_separation && !inputs.is_set) {
    throw UsageError("--field separation needs a folder, or several files with -s");
  }
  if (has_stdin(inputs.files) && inputs.is_set && request_of(options, true).between.is_between()) {
    throw UsageError("standard input can be read only once, so it cannot be part of a set");
  }
}

/// Rejects a journal with standard input: its files must be readable again.
void check_stdin(const Options& options) {
  const bool has_journal = options.resume || (options.ndjson && !options.ndjson->is_stdout());
  if (has_stdin(options.paths) && has_journal) {
    throw UsageError("no journal can tell whether standard input (-) is still the same");
  }
}

/// Removes repeated files, because a file named twice is one mesh of a set.
void drop_repeated(std::vector<std::string>& files) {
  std::set<std::string> met;
  std::erase_if(files, [&](const std::string& file) { return !met.insert(file).second; });
}

}  // namespace

Inputs inputs_of(const Options& options) {
  check_folders(options);
  check_stdin(options);
  Inputs inputs = find_inputs(options.paths);
  decide_set(options, inputs);
  if (inputs.is_set) {
    drop_repeated(inputs.files);
  }
  inputs.names = set_names(inputs.files);
  return inputs;
}

}  // namespace meshalyzer
