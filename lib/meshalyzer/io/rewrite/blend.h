#pragma once

#include "meshalyzer/io/rewrite/edited_mesh.h"
#include "meshalyzer/io/rewrite/face_plan.h"

#include <array>
#include <vector>

namespace meshalyzer {

/// A weighted mean of attributes of the source.
struct Blend {
  /// What they are attributes of; kNoIndex where there are fewer than three.
  std::array<Index, 3> items{kNoIndex, kNoIndex, kNoIndex};
  /// They add up to 1.
  std::array<double, 3> weights{};

  [[nodiscard]] bool is_empty() const { return items[0] == kNoIndex; }
  /// Whether it is of one item alone, which is the first.
  [[nodiscard]] bool is_single() const { return !is_empty() && items[1] == kNoIndex; }
  /// The item that weighs most; the first of equal ones.
  [[nodiscard]] Index main_item() const;

  /// The mean of a number that each item has.
  template <typename NumberOf>
  [[nodiscard]] double mean(NumberOf number_of) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < items.size() && items[i] != kNoIndex; ++i) {
      sum += weights[i] * number_of(items[i]);
    }
    return sum;
  }
};

/// All of one item.
[[nodiscard]] Blend single_blend(Index item);

/// How much each corner of a triangle weighs at the point of it that is nearest to a place.
/// @param items  What stands at the corners.
/// @return       Corners that weigh nothing are left out.
[[nodiscard]] Blend blend_at(const Vec3& place, const std::array<Vec3, 3>& corners,
                             const std::array<Index, 3>& items);

/// Returns where a corner of a written face takes its attributes from: of the corners of the face
/// record that the face was made of, counted in the order of the file. A vertex that this record
/// names has those of its corner; any other is somewhere on the triangle that the face was made of,
/// so that attributes never come from beyond a seam. Empty in a hole patch.
[[nodiscard]] Blend corner_blend(const EditedMesh& mesh, const FaceRecords& records,
                                 FanCorner corner);

/// Returns where each added vertex takes its attributes from, in their order: of the vertices of
/// the source. A copy has those of what it is a copy of, a vertex on a face those of the face
/// there, one of a hole patch those of a vertex at its rim.
///
/// @complexity O(#F).
[[nodiscard]] std::vector<Blend> added_vertex_blends(const EditedMesh& mesh);

}  // namespace meshalyzer
