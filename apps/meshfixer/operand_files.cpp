#include "operand_files.h"

#include "mesh_paths.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/boolean/solid_fault.h"
#include "meshalyzer/io/read.h"
#include "targets.h"

namespace meshalyzer::fixer {

OperandFiles read_operands(const Options& options) {
  const auto [paths, errors, has_folder] = find_meshes(options.paths);
  if (!errors.empty()) throw Error(errors.front());
  static_cast<void>(files_of_run(options, paths));
  if (options.target == Options::Target::Folder) {
    for (const std::string& path : paths) require_format(result_path(options, path));
  }
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

}  // namespace meshalyzer::fixer
