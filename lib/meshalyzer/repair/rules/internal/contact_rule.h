#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/align_faces.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <algorithm>

namespace meshalyzer {

// The first rule for operations: an operation may not bring faces into contact. Passes that check
// their candidates beforehand use the same predicates as acceptance.h.

/// A face that exists or is proposed: the file numbers of its vertices, and its corners in space.
struct PlacedFace {
  Triangle vertices;
  Corners corners;
};

/// Tells whether the boxes of two faces are disjoint.
[[nodiscard]] inline bool are_boxes_apart(const Corners& a, const Corners& b) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto of_a = std::minmax({a[0][k], a[1][k], a[2][k]});
    const auto of_b = std::minmax({b[0][k], b[1][k], b[2][k]});
    if (of_a.second < of_b.first || of_b.second < of_a.first) return true;
  }
  return false;
}

/// Tells whether two faces share a point that is not part of their common corners. The answer is
/// exact.
///
/// @param same  Returns whether two vertices, by number, count as one.
template <typename Same>
[[nodiscard]] bool are_in_contact(const PlacedFace& a, const PlacedFace& b, Same&& same) {
  if (are_boxes_apart(a.corners, b.corners)) return false;
  const Triangle corners{0, 1, 2};
  const auto [p, q, n_common] = align_faces(
      corners, corners, [&](Index i, Index j) { return same(a.vertices[i], b.vertices[j]); });
  const Corners of_a{a.corners[p[0]], a.corners[p[1]], a.corners[p[2]]};
  const Corners of_b{b.corners[q[0]], b.corners[q[1]], b.corners[q[2]]};
  const auto common = static_cast<Common>(n_common);
  return !are_clearly_apart(of_a, of_b, common) && find_contact(of_a, of_b, common).has_value();
}

/// Does the same where vertices count as one by their number only.
[[nodiscard]] bool are_in_contact(const PlacedFace& a, const PlacedFace& b);

/// Does the same, but ignores contact at nothing but copies of one vertex at the same position.
[[nodiscard]] bool are_in_contact_beyond_copies(const PlacedFace& a, const PlacedFace& b);

/// Returns how many vertices two faces have in common by number.
[[nodiscard]] std::size_t count_common_vertices(const PlacedFace& a, const PlacedFace& b);

}  // namespace meshalyzer
