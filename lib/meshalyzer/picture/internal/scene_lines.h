#pragma once

#include "meshalyzer/picture/internal/drawing_frame.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

/// The lines that are drawn of a whole mesh.
struct DrawnLines {
  SceneLines lines;
  /// Sentences about lines that are omitted because they are too many.
  std::vector<std::string> notes;
};

/// Draws the lines of a mesh.
///
/// @param max  The largest number of segments of each kind.
[[nodiscard]] DrawnLines draw_lines(const PreparedMesh& mesh, const DrawingFrame& frame,
                                    std::size_t max);

}  // namespace meshalyzer
