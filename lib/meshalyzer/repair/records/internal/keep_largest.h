#pragma once

#include "meshalyzer/repair/pass.h"

#include <cstddef>

namespace meshalyzer {

/// Proposes to drop all but the largest components, by faces, then by lowest face; in one
/// operation. The deviation is not checked, because the user asks for it.
[[nodiscard]] PassResult keep_largest(const PassInput& input, std::size_t n);

}  // namespace meshalyzer
