#pragma once

#include "options.h"

namespace meshalyzer {

/// @throws UsageError where options exclude each other, or one lacks another that it needs.
void check_options(const Options& options);

}  // namespace meshalyzer
