#pragma once

#include "meshalyzer/arrangement/point_name.h"

#include <vector>

namespace meshalyzer {

/// A face as a set of points: a triangle, or a segment or a point if its area is zero.
struct FaceSimplex {
  Index face = kNoIndex;
  Triangle vertices{};
  /// The dimension: 2, 1 or 0.
  int dimension = 2;
  /// An axis along which a triangle projects to non-zero area.
  Axis axis = Axis::X;
  /// The ends of a segment, the lexicographically lower one first.
  VertexPair ends{};

  [[nodiscard]] bool is_triangle() const { return dimension == 2; }
  /// Returns the edges of a triangle, the one of a segment, none of a point.
  [[nodiscard]] std::vector<VertexPair> edges() const;
};

/// Returns the simplex of a face, which must be in the complex.
[[nodiscard]] FaceSimplex face_simplex(const Soup& soup, Index face);

/// Tells whether x lies on the closed segment between two vertices, whose positions differ.
[[nodiscard]] bool is_on_segment(const Soup& soup, const VertexPair& ends, Index x);

/// Tells whether a vertex lies in the closed simplex.
[[nodiscard]] bool contains(const Soup& soup, const FaceSimplex& simplex, Index x);

/// Tells on which side of a triangle's plane a vertex lies, as orient3d() does.
[[nodiscard]] Sign side_of(const Soup& soup, const FaceSimplex& triangle, Index x);

}  // namespace meshalyzer
