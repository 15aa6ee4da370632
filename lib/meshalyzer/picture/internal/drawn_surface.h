#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/picture/internal/drawing_frame.h"
#include "meshalyzer/picture/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Triangles over the vertex records of a soup.
struct TriangleList {
  std::vector<Triangle> triangles;
  /// The face that each triangle is or comes from.
  std::vector<Index> faces;
};

/// Tells whether all corners of a face are defined and finite.
[[nodiscard]] bool is_drawable(const Soup& soup, Index face);

/// Returns the faces that can be drawn, ascending.
[[nodiscard]] std::vector<Index> drawable_faces(const Soup& soup);

/// Returns the box of the corners of these faces or, if there are none, of all finite vertices: the
/// scene is drawn about its centre.
[[nodiscard]] Box3 box_of(const Soup& soup, std::span<const Index> faces);

/// Returns faces without decimation.
[[nodiscard]] TriangleList triangles_of(const Soup& soup, std::vector<Index> faces);

/// Marks the vertices that triangles use.
///
/// @return  #V: 1 for vertices that are used.
[[nodiscard]] std::vector<std::uint8_t> used_vertices(const Soup& soup, const TriangleList& list);

/// Makes the arrays of a surface, its vertices in the order of their records.
///
/// @param normals  #V of the soup: the normal of each vertex.
[[nodiscard]] DrawnSurface draw_surface(const Soup& soup, const DrawingFrame& frame,
                                        TriangleList list, std::span<const Vec3> normals);

}  // namespace meshalyzer
