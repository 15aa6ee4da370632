#include "operand_files.h"

#include "mesh_folder.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/boolean/solid_fault.h"
#include "meshalyzer/io/read.h"
#include "same_file.h"
#include "usage_error.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace meshalyzer::fixer {
namespace {

std::vector<std::string> find_paths(const Options& options) {
  std::vector<std::string> paths;
  for (const std::string& path : options.paths) {
    if (!is_folder(path)) {
      paths.push_back(path);
      continue;
    }
    MeshFolder folder = list_mesh_folder(path);
    if (!folder.error.empty()) throw Error(folder.error);
    paths.insert(paths.end(), folder.files.begin(), folder.files.end());
  }
  return paths;
}

/// Rejects an output that would overwrite an input, or a report that would overwrite OUT.
void check_targets(const Options& options, const std::vector<std::string>& paths) {
  const KnownFiles known(paths);
  const bool is_one_file = options.output && !options.is_batch() && !options.writes_to_stdout();
  if (is_one_file && known.contain(*options.output)) {
    throw UsageError("OUT is an input, which never changes");
  }
  const auto check = [&](const std::string& file, const std::string& option) {
    if (known.contain(file)) {
      throw UsageError("the FILE of " + option + " is an input, which never changes");
    }
    if (is_one_file && is_same_file(*options.output, file)) {
      throw UsageError("the FILE of " + option + " is OUT");
    }
  };
  if (options.json && !options.json->is_stdout()) check(options.json->file, "--json");
  if (options.html) check(*options.html, "--html");
}

}  // namespace

OperandFiles read_operands(const Options& options) {
  const std::vector<std::string> paths = find_paths(options);
  check_targets(options, paths);
  OperandFiles operands;
  for (const std::string& path : paths) {
    operands.files.push_back(std::make_unique<const InputFile>(path));
    operands.soups.push_back(parse_mesh(operands.files.back()->bytes(), path));
  }
  return operands;
}

std::string solid_faults(const OperandFiles& operands) {
  std::string text;
  for (std::size_t i = 0; i < operands.soups.size(); ++i) {
    const std::string fault = find_solid_fault(operands.soups[i]);
    if (fault.empty()) continue;
    text += operands.files[i]->path() + ": bounds no solid: " + fault + "; repair it first\n";
  }
  return text;
}

void make_output_folder(const Options& options, const OperandFiles& operands) {
  if (options.target != Options::Target::Folder) return;
  std::vector<std::string> names;
  for (const auto& file : operands.files) {
    if (file->path() == "-") throw UsageError("standard input has no name to be written by");
    names.push_back(std::filesystem::path(file->path()).filename().string());
  }
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) {
    throw UsageError("two inputs are called " + *twice + ", and would be written to one file");
  }
  std::vector<std::string> inputs;
  for (const auto& file : operands.files) inputs.push_back(file->path());
  const KnownFiles known(inputs);
  for (const std::string& name : names) {
    const std::string path = (std::filesystem::path(*options.output) / name).string();
    if (known.contain(path)) {
      throw UsageError(path + " would be written, but it is an input, which never changes");
    }
  }
  std::error_code error;
  std::filesystem::create_directories(*options.output, error);
  if (error) throw IoError(*options.output, {}, "cannot be made a folder: " + error.message());
}

}  // namespace meshalyzer::fixer
