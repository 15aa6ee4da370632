#pragma once

#include "options.h"

#include <string_view>

namespace meshalyzer {

/// Checks that options fit together.
/// @throws UsageError if options exclude each other, or one lacks another that it needs.
void check_options(const Options& options);

/// Checks that one report at most goes to standard output.
/// @throws UsageError if there are more.
void check_reports(const Options& options);

/// Returns an option that has no effect unless the distances between the meshes of a set are
/// measured, or an empty text.
[[nodiscard]] std::string_view option_of_separation(const Options& options);

}  // namespace meshalyzer
