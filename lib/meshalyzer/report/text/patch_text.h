#pragma once

#include "meshalyzer/repair/driver/patch_outcome.h"

#include <cstddef>
#include <string>

namespace meshalyzer {

/// Says what a repair makes of a patch: "12 faces; mended by cut intersections; moved by at most
/// 0".
[[nodiscard]] std::string patch_text(const PatchOutcome& patch, std::size_t n_faces);

}  // namespace meshalyzer
