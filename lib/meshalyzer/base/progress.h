#pragma once

#include <functional>
#include <string_view>

namespace meshalyzer {

/// Told the name of each phase as it begins. May be empty. Called from the thread that called the
/// library.
using PhaseListener = std::function<void(std::string_view phase)>;

}  // namespace meshalyzer
