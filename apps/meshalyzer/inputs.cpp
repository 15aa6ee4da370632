#include "inputs.h"

#include "check_options.h"
#include "file_identity.h"
#include "mesh_paths.h"
#include "meshalyzer/set/set_files.h"
#include "request.h"
#include "usage_error.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
  const std::string_view option = option_of_separation(options);
  if (!option.empty() && !inputs.is_set) {
    throw UsageError(std::string(option) + " needs a folder, or several files with -s");
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

/// Removes files whose path was met before, also in another spelling (`d/a.mesh`, `./d/a.mesh`): a
/// file named twice is one mesh of a set. Links are meshes of their own.
void drop_repeated(std::vector<std::string>& files) {
  std::map<std::filesystem::path, std::string> met;
  std::erase_if(files, [&](const std::string& file) {
    const auto normal = std::filesystem::absolute(file).lexically_normal();
    const auto [first, is_new] = met.emplace(normal, file);
    // After a link to a folder, ".." leads elsewhere than the text tells.
    return !is_new && is_same_file(first->second, file);
  });
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
