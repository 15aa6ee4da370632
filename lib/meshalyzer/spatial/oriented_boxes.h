#pragma once

#include "meshalyzer/spatial/closest_point.h"
#include "meshalyzer/spatial/eight_reaches.h"

#include <array>
#include <cstddef>
#include <span>

namespace meshalyzer {

/// Returns the oriented boxes of eight leaves of a FaceTree that follow each other.
///
/// A box lies along the mean normal of its faces, because eight faces of a surface are mostly flat,
/// and in their plane along the axis on which the leaf is widest, because the tree splits across
/// the axes. That of a leaf with far faces is all of space; leaves that the tree does not have are
/// infinitely far away.
///
/// @param triangles  #leaves of the tree.
[[nodiscard]] EightOrientedBoxes oriented_boxes_of(const FaceTree& tree,
                                                   std::span<const EightTriangles> triangles,
                                                   std::size_t first_leaf);

/// Returns lower bounds of the squared distances of eight boxes from a point.
///
/// The directions are those of a rotation, each coordinate rounded once: as a matrix they make a
/// vector longer by 2 u of its length at most, with u = 2^-24. So the true distance is at least the
/// root of the sum of the squares of the gaps, less 2 u of it.
[[nodiscard]] inline EightFloats squared_distances(const EightOrientedBoxes& boxes,
                                                   const std::array<float, 3>& from) {
  const EightFloats zero = EightFloats::all(0.0F);
  const EightVectors point = eight_times(from);
  EightFloats squared = zero;
  for (std::size_t a = 0; a < 3; ++a) {
    const EightFloats along = dot_product(loaded(boxes.axes[a]), point);
    const EightFloats below = EightFloats::load(boxes.low[a]) - along;
    const EightFloats above = along - EightFloats::load(boxes.high[a]);
    const EightFloats gap = max(max(below, above), zero);
    squared = squared + gap * gap;
  }
  return squared;
}

}  // namespace meshalyzer
