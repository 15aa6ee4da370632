#pragma once

#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/mesh/face_parts.h"
#include "meshalyzer/mesh/side_table.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Returns the boxes of the vertices that the faces of each part use.
///
/// @return One box for each part, empty for a part without faces.
[[nodiscard]] std::vector<Box3> bounding_boxes(const TriMesh& mesh, const FaceParts& parts);

/// A volume computed by the divergence theorem.
struct SignedVolume {
  /// The volume in the mesh's unit cubed; positive when the normals point outward. It is accurate
  /// for any input, even where the terms of the sum cancel.
  double value = 0.0;
  /// The sign of the true value, which is exact even where `value` underflows to 0.
  Sign sign = 0;
};

/// Returns the signed volume of each part: the sum of det(a, b, c) / 6 over its faces.
///
/// It is the enclosed volume only for a closed, consistently oriented part; for others it depends
/// on the position of the origin, so that an analysis states no volume for an open mesh. The sum is
/// compensated and taken about the centre of the part's box, so that a mesh far from the origin
/// keeps its digits.
///
/// @param boxes  The result of bounding_boxes().
/// @complexity   O(#F); exact arithmetic is needed only for parts that are so thin that in floating
///               point the terms cancel.
[[nodiscard]] std::vector<SignedVolume> signed_volumes(const TriMesh& mesh, const FaceParts& parts,
                                                       std::span<const Box3> boxes);

}  // namespace meshalyzer
