#pragma once

#include "meshalyzer/exact/exact_point.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// A triangulation of the convex hull of coplanar points.
///
/// Triangle t has the half-edges 3 t, 3 t + 1 and 3 t + 2, counter-clockwise in the projection.
struct Triangulation {
  /// An axis along which the plane projects to non-zero area.
  Axis dropped = Axis::Z;
  /// The points in lexicographic order, all different. The triangulation only refers to them.
  std::vector<const ExactPoint*> points;
  /// #half-edges: the vertex at which each begins.
  std::vector<Index> origin;
  /// #half-edges: the other half of the edge; kNoIndex on the hull.
  std::vector<Index> twin;
  /// #half-edges: 1 if the edge lies on an inserted segment, on both halves.
  std::vector<std::uint8_t> constrained;
  /// #vertices: a half-edge that leaves each.
  std::vector<Index> leaving;

  [[nodiscard]] static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  [[nodiscard]] std::size_t n_triangles() const { return origin.size() / 3; }
  [[nodiscard]] Index target(Index h) const { return origin[next(h)]; }
  /// Returns the turn at three vertices in the projection: 1 to the left, -1 to the right.
  [[nodiscard]] Sign turn(Index a, Index b, Index c) const {
    return orient2d(dropped, *points[a], *points[b], *points[c]);
  }

  /// Appends a triangle that is linked to nothing yet, and returns its first half-edge.
  Index add_triangle(Index a, Index b, Index c);
  /// Makes h and g, which may be kNoIndex, the halves of one edge.
  void link(Index h, Index g);
  /// Marks an edge as constrained.
  void constrain(Index h);
  /// Collects the half-edges that leave a vertex, in arbitrary order.
  void collect_leaving(Index vertex, std::vector<Index>& halfedges) const;
};

}  // namespace meshalyzer
