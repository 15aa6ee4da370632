#pragma once

#include <functional>
#include <string_view>

namespace meshalyzer {

/// Receives the name of each phase as it begins, on the thread that called the library. It may be
/// empty.
using PhaseListener = std::function<void(std::string_view phase)>;

}  // namespace meshalyzer
