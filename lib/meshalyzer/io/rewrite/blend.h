#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/io/rewrite/edited_mesh.h"
#include "meshalyzer/io/rewrite/face_plan.h"

#include <array>
#include <vector>

namespace meshalyzer {

/// A weighted mean of attributes of the source.
struct Blend {
  /// The items whose attributes are blended; kNoIndex if there are fewer than three.
  std::array<Index, 3> items{kNoIndex, kNoIndex, kNoIndex};
  /// The weights, whose sum is 1.
  std::array<double, 3> weights{};

  [[nodiscard]] bool is_empty() const { return items[0] == kNoIndex; }
  /// Tells whether the blend has only one item, the first.
  [[nodiscard]] bool is_single() const { return !is_empty() && items[1] == kNoIndex; }
  /// Returns the item with the largest weight, the first of equal ones.
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

/// Returns the blend of a single item.
[[nodiscard]] Blend single_blend(Index item);

/// Returns the weights of the corners at the point of a triangle nearest to a position.
/// @param items  The items at the corners.
/// @return       The blend, without corners of weight 0.
[[nodiscard]] Blend blend_at(const Vec3& place, const Corners& corners,
                             const std::array<Index, 3>& items);

/// Returns the triangle of the source that a face is or was made from; kNoIndex in a hole patch.
[[nodiscard]] Index model_of(const ElementOrigin& origin);

/// Returns for each added vertex the blend of source vertices that gives its attributes. A copy has
/// those of its original, a vertex on a face those of the face there, one of a hole patch those of
/// a vertex at its rim.
///
/// @complexity O(#F).
[[nodiscard]] std::vector<Blend> added_vertex_blends(const EditedMesh& mesh);

}  // namespace meshalyzer
