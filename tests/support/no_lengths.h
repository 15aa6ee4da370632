#pragma once

#include "support/constants.h"

#include <array>
#include <limits>

namespace meshalyzer::test {

/// Values that are no length.
inline constexpr std::array kNoLengths{kNaN, kInfinity, -kInfinity,
                                       -std::numeric_limits<double>::denorm_min()};

}  // namespace meshalyzer::test
