#pragma once

#include "meshalyzer/picture/drawing_frame.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/prepared/prepared_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

// Private to the picture module: the lines of the whole mesh.

struct DrawnLines {
  SceneLines lines;
  /// About those that are too many.
  std::vector<std::string> notes;
};

/// @param max  Segments of each kind.
[[nodiscard]] DrawnLines draw_lines(const PreparedMesh& mesh, const DrawingFrame& frame,
                                    std::size_t max);

}  // namespace meshalyzer
