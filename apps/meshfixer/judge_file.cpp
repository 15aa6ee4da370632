#include "judge_file.h"

#include "meshalyzer/analysis/analyze.h"

namespace meshalyzer::fixer {

Goodness judge_file(const Soup& mesh, const std::string& path) {
  AnalysisOptions options;
  options.scope = Scope::AttributesOnly;
  options.judge_fitness = true;
  return analyze(mesh, path, options).fitness.value();
}

}  // namespace meshalyzer::fixer
