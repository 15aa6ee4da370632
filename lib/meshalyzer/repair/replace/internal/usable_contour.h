#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/contour/contour_mesh.h"

#include <optional>

namespace meshalyzer {

/// Returns why a contour cannot replace anything; null if it can.
///
/// @param wants_to_stop  As of the limits of contour_mesh().
[[nodiscard]] inline const char* reason_against(const std::optional<ContouredMesh>& contour,
                                                const StopQuery& wants_to_stop) {
  if (!contour && wants_to_stop()) return "there was no time left for a replacement";
  if (!contour) {
    return "no grid for a replacement can be laid round it: it has no extent, or its coordinates "
           "are too large for its size";
  }
  if (!contour->is_within) {
    return "a replacement within the maximum deviation needs a finer grid than memory and time "
           "allow";
  }
  return nullptr;
}

}  // namespace meshalyzer
