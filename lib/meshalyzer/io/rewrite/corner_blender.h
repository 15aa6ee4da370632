#pragma once

#include "meshalyzer/io/rewrite/blend.h"
#include "meshalyzer/mesh/vertex_faces.h"

#include <functional>
#include <memory>
#include <optional>

namespace meshalyzer {

/// Returns a corner of a triangle of the source, as one number.
[[nodiscard]] inline Index corner_number(FanCorner corner) {
  return 3 * corner.triangle + static_cast<Index>(corner.corner);
}
[[nodiscard]] inline FanCorner corner_of_number(Index number) {
  return {number / 3, number % 3};
}

/// Finds the blends of source corners that give the corners of rewritten faces their attributes,
/// see corner_number().
class CornerBlender {
 public:
  /// Tells whether two corners of the source at one vertex have the same attributes, so that there
  /// is no seam between their faces.
  using HasSameAttributes = std::function<bool(Index, Index)>;

  /// @param mesh, records  The mesh and its records, which must outlive the object.
  CornerBlender(const EditedMesh& mesh, const FaceRecords& records,
                HasSameAttributes has_same_attributes);

  /// Returns the blend of a corner; empty in a hole patch. If the vertex occurs in the record from
  /// which the face was made, it has the attributes of its corner there. Beyond an edge of that
  /// record it has those of the face there, unless the edge is on a seam. Any other vertex lies on
  /// the triangle from which the face was made, so that attributes never come from beyond a seam.
  [[nodiscard]] Blend blend(FanCorner corner);

 private:
  [[nodiscard]] std::optional<Index> corner_in_record(Index model, Index vertex) const;
  [[nodiscard]] std::optional<Index> corner_beside(Index model, Index vertex);
  [[nodiscard]] bool has_seam_between(Index a, Index b) const;

  const EditedMesh& mesh_;
  const FaceRecords& records_;
  HasSameAttributes has_same_attributes_;
  /// The faces of the source by their vertices, built at first use.
  std::unique_ptr<VertexFaces> faces_;
};

}  // namespace meshalyzer
