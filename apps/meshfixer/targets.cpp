#include "targets.h"

#include "make_folder.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/io/format_of.h"
#include "usage_error.h"

#include <filesystem>

namespace meshalyzer::fixer {
namespace {

/// Adds the results of a run that writes one for each input, and the backups.
void add_results(const Options& options, const std::vector<std::string>& inputs, RunFiles& files) {
  for (const std::string& input : inputs) {
    if (input == "-") throw UsageError("standard input has no name for the file of its result");
    files.add_output(result_path(options, input), input);
    if (options.backup == Options::Backup::Original) {
      files.add_output(backup_path(input), "the backup of " + input);
    }
  }
}

void add_reports(const Options& options, RunFiles& files) {
  if (options.json) files.add_output(options.json->file, "the report of --json");
  if (options.ndjson) files.add_output(options.ndjson->file, "the lines of --ndjson");
  if (options.html) files.add_output(*options.html, "the page of --html");
}

}  // namespace

std::string result_path(const Options& options, const std::string& input) {
  if (options.target == Options::Target::InPlace) return input;
  if (options.target == Options::Target::File) return *options.output;
  const std::filesystem::path name = std::filesystem::path(input).filename();
  return (std::filesystem::path(*options.output) / name).string();
}

void require_format(const std::string& result) {
  if (!format_of_name(result)) {
    throw IoError(result, {},
                  std::string("has the ending of no known mesh format (") + kMeshEndings + ")");
  }
}

std::string backup_path(const std::string& input) {
  return input + ".orig";
}

RunFiles files_of_run(const Options& options, const std::vector<std::string>& inputs) {
  RunFiles files;
  if (options.target != Options::Target::InPlace) {
    for (const std::string& input : inputs) files.add_input(input);
  }
  if (options.is_batch()) {
    add_results(options, inputs, files);
  } else if (options.output) {
    files.add_output(*options.output, "the result");
  }
  add_reports(options, files);
  return files;
}

void make_output_folder(const Options& options) {
  if (options.target == Options::Target::Folder) make_folder(*options.output);
}

}  // namespace meshalyzer::fixer
