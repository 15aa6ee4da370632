#include "operand_files.h"

#include "freed_memory.h"
#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/boolean/solid_fault.h"
#include "meshalyzer/io/read.h"
#include "targets.h"

#include <cstddef>

namespace meshalyzer::fixer {

OperandFiles read_operands(const Options& options, const MeshPaths& paths) {
  if (!paths.errors.empty()) throw Error(paths.errors.front());
  if (options.target == Options::Target::Folder) {
    for (const std::string& path : paths.files) require_format(result_path(options, path));
  }
  OperandFiles operands;
  std::size_t n_bytes = 0;
  for (const std::string& path : paths.files) {
    operands.files.push_back(std::make_unique<const InputFile>(path));
    n_bytes += operands.files.back()->bytes().size();
    keep_freed_memory_if_small(n_bytes);
    operands.soups.push_back(parse_mesh(operands.files.back()->bytes(), path));
  }
  return operands;
}

std::string solid_faults(const OperandFiles& operands) {
  std::string text;
  for (std::size_t i = 0; i < operands.soups.size(); ++i) {
    const std::string fault = find_solid_fault(operands.soups[i]);
    if (fault.empty()) continue;
    if (!text.empty()) text += '\n';
    text += without_controls(operands.files[i]->path()) + ": bounds no solid: " + fault +
            "; repair it first";
  }
  return text;
}

}  // namespace meshalyzer::fixer
