#pragma once

#include "meshalyzer/repair/pass.h"

#include <cstddef>

namespace meshalyzer {

/// Proposes to drop all but the largest components, by faces, then by lowest face; in one
/// operation. Not judged by the deviation: it is what the user asks for.
[[nodiscard]] PassResult keep_largest(const PassInput& input, std::size_t n);

}  // namespace meshalyzer
