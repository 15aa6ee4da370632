#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <string>

namespace meshalyzer::fixer {

/// Judges a mesh as `meshalyzer` judges the file in which it is.
///
/// @param mesh  What was read from the file.
[[nodiscard]] Goodness judge_file(const Soup& mesh, const std::string& path);

}  // namespace meshalyzer::fixer
