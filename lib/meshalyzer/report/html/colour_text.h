#pragma once

#include "meshalyzer/base/colour_map.h"
#include "meshalyzer/defects/defect.h"

#include <string>

namespace meshalyzer {

/// Returns a colour as "#rrggbb".
[[nodiscard]] std::string colour_text(const Colour& colour);

/// Returns the colour of defects of a code, in lists and drawings: no two codes have the same.
[[nodiscard]] inline std::string colour_text(DefectCode code) {
  return colour_text(category_colour(static_cast<std::size_t>(code)));
}

}  // namespace meshalyzer
