#pragma once

#include "meshalyzer/picture/internal/drawing_frame.h"
#include "meshalyzer/picture/internal/drawn_surface.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The limits of decimation. The caller keeps the data.
struct ClusterLimits {
  /// The largest number of faces that may be left; the result has not many fewer if the mesh
  /// allows.
  std::size_t max_faces = 0;
  /// #V: non-zero for vertices that stay as they are, so that no gap opens beside faces drawn in
  /// detail. They are ignored if the faces at them are too many.
  std::span<const std::uint8_t> pinned;
};

/// Decimates faces by vertex clustering (Rossignac and Borrel 1993): the vertices in each cell of a
/// uniform grid become one of them, the one that is closest to their mean. Faces that lose a corner
/// are dropped, and all but the first of faces that become equal in either orientation.
///
/// The size of the cells is the smallest of a few tried ones that leaves no more faces than
/// allowed. If all faces are allowed, they stay as they are.
///
/// @param faces  Drawable faces, ascending.
/// @return       Triangles in the order of the faces that they come from.
/// @complexity   O(#V log #V + #F).
[[nodiscard]] TriangleList cluster_vertices(const Soup& soup, const DrawingFrame& frame,
                                            std::vector<Index> faces, const ClusterLimits& limits);

}  // namespace meshalyzer
