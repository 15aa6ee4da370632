#pragma once

#include "options.h"

namespace meshalyzer {

/// Checks that options fit together.
/// @throws UsageError if options exclude each other, or one lacks another that it needs.
void check_options(const Options& options);

}  // namespace meshalyzer
