#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/closest_point.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to DeviationMeter.

/// A surface whose closest points can be searched. It is neither copied nor moved, because its
/// parts refer to each other.
struct SearchedSurface {
  explicit SearchedSurface(const Soup& soup) : cut(build(soup)) {}
  SearchedSurface(const SearchedSurface&) = delete;
  SearchedSurface& operator=(const SearchedSurface&) = delete;

  CutMesh cut;
  FaceTree tree{cut};
  ClosestPoints closest{tree};
};

/// Returns a box for each triangle, round all points within a distance of it.
[[nodiscard]] std::vector<Box3> boxes_within(std::span<const Corners> triangles, double distance);

/// Finds the faces of a surface that may have a point within a distance of some triangles.
///
/// @return      Ascending.
/// @complexity  That of find_faces_near().
[[nodiscard]] std::vector<Index> faces_within(const Soup& surface,
                                              std::span<const Corners> triangles, double distance);

/// Returns these faces, in the same order.
[[nodiscard]] Soup part_within(const Soup& surface, std::span<const Corners> triangles,
                               double distance);

}  // namespace meshalyzer
