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

/// Returns for each box one with all points within a distance of it.
[[nodiscard]] std::vector<Box3> boxes_within(std::vector<Box3> boxes, double distance);

/// Returns the faces of a surface that find_faces_near() finds.
[[nodiscard]] Soup part_near(const Soup& surface, std::span<const Box3> boxes);

}  // namespace meshalyzer
