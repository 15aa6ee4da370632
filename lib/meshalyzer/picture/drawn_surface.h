#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/picture/drawing_frame.h"
#include "meshalyzer/picture/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the picture module: which faces can be drawn, and their arrays.

/// Triangles over the vertex records of a soup.
struct TriangleList {
  std::vector<Triangle> triangles;
  /// The face that each one is, or comes from.
  std::vector<Index> faces;
};

/// Whether all corners of a face are there and finite.
[[nodiscard]] bool is_drawable(const Soup& soup, Index face);

/// The faces that can be drawn, ascending.
[[nodiscard]] std::vector<Index> drawable_faces(const Soup& soup);

/// The box that a scene is drawn about: of the corners of these faces; where there are none of all
/// finite vertices.
[[nodiscard]] Box3 box_of(const Soup& soup, std::span<const Index> faces);

/// Faces as they are.
[[nodiscard]] TriangleList triangles_of(const Soup& soup, std::vector<Index> faces);

/// The vertices that triangles use: #V, 1 for those.
[[nodiscard]] std::vector<std::uint8_t> used_vertices(const Soup& soup, const TriangleList& list);

/// Makes the arrays of a surface, its vertices in the order of their records.
/// @param normals  #V of the soup.
[[nodiscard]] DrawnSurface draw_surface(const Soup& soup, const DrawingFrame& frame,
                                        TriangleList list, std::span<const Vec3> normals);

}  // namespace meshalyzer
