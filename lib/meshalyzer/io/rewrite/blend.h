#pragma once

#include "meshalyzer/base/corners.h"
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
  /// Tells whether it is of one item alone, which is the first.
  [[nodiscard]] bool is_single() const { return !is_empty() && items[1] == kNoIndex; }
  /// Returns the item that weighs most; the first of equal ones.
  [[nodiscard]] Index main_item() const;

  /// Returns the mean of a number that each item has.
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
[[nodiscard]] Blend blend_at(const Vec3& place, const Corners& corners,
                             const std::array<Index, 3>& items);

/// Returns the triangle of the source that a face is or was made of; kNoIndex in a hole patch.
[[nodiscard]] Index model_of(const ElementOrigin& origin);

/// Returns where each added vertex takes its attributes from, in their order: of the vertices of
/// the source. A copy has those of what it is a copy of, a vertex on a face those of the face
/// there, one of a hole patch those of a vertex at its rim.
///
/// @complexity O(#F).
[[nodiscard]] std::vector<Blend> added_vertex_blends(const EditedMesh& mesh);

}  // namespace meshalyzer
