#pragma once

#include "meshalyzer/picture/scene.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to the picture module: fields where they are drawn.

/// Takes the values of fields at the vertices and faces that are drawn.
/// @complexity O(#V + #F) a field.
[[nodiscard]] std::vector<DrawnField> draw_fields(std::span<const Field> fields,
                                                  const DrawnSurface& detail,
                                                  const DrawnSurface& context);

}  // namespace meshalyzer
