#pragma once

#include "meshalyzer/base/types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The direction in which a face crosses an edge from a to b.
enum class Crossing : std::uint8_t {
  /// a comes before b in its corners.
  Along,
  Against,
};

/// A face at an edge.
struct FaceAtEdge {
  /// The corner that is not on the edge.
  Vec3 apex = Vec3::Zero();
  Crossing crossing = Crossing::Along;
  /// The same number for faces that are connected elsewhere; kNoIndex if that is unknown.
  Index component = kNoIndex;
  /// See ManifoldComponents: 0 if the component of the face has no border, 1 if it has nothing
  /// else. A fin is open, a wall is not.
  double border_share = 0.0;
};

/// The pairing of the faces at an edge.
struct EdgePairing {
  /// #faces: the one that each is joined to; kNoIndex if it ends there.
  std::vector<Index> partner;
  /// Tells whether faces that begin a solid alternate with those that end one all the way round:
  /// then each is joined to the other side of the material between them, and the pairing is unique.
  bool alternates = false;
};

/// Pairs the faces at an edge from a to b, so that each solid stays closed.
///
/// Faces are sorted by their angle round the edge, exactly; those at one angle so that they
/// alternate as far as possible, then in the order given. Two that face away from the space between
/// them have material there, and are joined: solids that share the edge are separated.
///
/// If orientations do not alternate, one of each run of faces with the same orientation is joined:
/// those that are least open and have the least material between them; or, if the number is odd and
/// one must be a fin or an inner wall, those of one component first, then those that are least open
/// and continue most smoothly. The remaining faces are paired in the same way, then faces with the
/// same orientation. No pair passes through another. Faces of zero area have no angle and come
/// last.
///
/// @complexity O(n log n) for n faces that alternate; above 32 faces no two of the same orientation
/// are joined.
[[nodiscard]] EdgePairing pair_round_edge(const Vec3& a, const Vec3& b,
                                          std::span<const FaceAtEdge> faces);

}  // namespace meshalyzer
