#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/spatial/far_field.h"
#include "meshalyzer/spatial/two_vectors.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// Winding numbers by the far fields of groups of triangles. It is an implicit, complete tree with
/// eight children per node over the triangles, ordered by size and along a space-filling curve.
class FarFieldTree {
 public:
  /// @param triangles  Triangles with coordinates of about -1 ... 1.
  /// @param near       A point within this distance of a triangle is on it.
  /// @param far        A node is approximated as a whole beyond this many of its radii.
  FarFieldTree(std::span<const Corners> triangles, double near, double far);

  /// Returns the winding numbers at two points.
  [[nodiscard]] Two at(const TwoVectors& points) const;

 private:
  /// Returns the far fields of `length` triangles each.
  [[nodiscard]] std::vector<FarField> level_of(std::size_t length) const;

  double near_;
  double far_;
  std::vector<Corners> triangles_;
  /// Level 0 has the far fields of eight triangles each; each other level those of eight nodes
  /// below.
  std::vector<std::vector<FarField>> levels_;
};

}  // namespace meshalyzer
