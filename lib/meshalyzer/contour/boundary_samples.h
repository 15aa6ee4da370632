#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/spatial/winding_number.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// A sample of some pieces of faces.
struct PieceSample {
  Vec3 point;
  /// The number of the piece that it lies on.
  Index piece = kNoIndex;
};

/// Samples pieces of faces.
///
/// @return  Points in the order of their pieces, no more than the spacing apart, and at least one
///          for each piece that has an area.
[[nodiscard]] std::vector<PieceSample> sample_pieces(std::span<const Corners> pieces,
                                                     double spacing);

/// The boundary of the solid that a mesh represents: where the winding number of the mesh is near 0
/// on one side, and at least near 1 in magnitude on the other. Parts near holes, where it is
/// midway, do not belong to it.
class SolidBoundary {
 public:
  /// @param reach  The two sides of a face are examined at this distance from it; positive.
  SolidBoundary(const Soup& mesh, double reach);

  /// Tells whether a point of a face, or of a piece of one, lies on the boundary; several threads
  /// may ask at a time.
  ///
  /// @complexity O(log #F) on average; it takes longer than to find the point nearest to another.
  [[nodiscard]] bool is_at(const Vec3& point, const Corners& piece) const;

 private:
  WindingNumbers windings_;
  double reach_;
};

}  // namespace meshalyzer
