#pragma once

#include "meshalyzer/base/types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// Tells which way a face crosses an edge from a to b.
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
  /// The same number for faces that hang together elsewhere; kNoIndex: nothing is known.
  Index component = kNoIndex;
  /// 0: the component has no border; 1: it has nothing else. A fin is open, a wall is not.
  double openness = 0.0;
};

/// Tells how the faces at an edge go on across it.
struct EdgePairing {
  /// #faces: the one that each is joined to; kNoIndex: none, it ends there.
  std::vector<Index> partner;
  /// Tells whether faces that begin a solid alternate with those that end one all the way round:
  /// then each is joined to the other side of the material between them, and nobody had to choose.
  bool alternates = false;
};

/// Returns pairs the faces at an edge from a to b, so that each solid stays closed.
///
/// Faces are sorted by their angle round the edge, exactly; those at one angle so that they
/// alternate as far as they can, then in the order given. Two that face away from what is between
/// them have material there, and are joined: solids that share the edge come apart.
///
/// Where orientations do not alternate, one of each run of faces that are oriented alike is joined:
/// those that are least open and have the least material between them; or, where the number is odd
/// and one must be a fin or an inner wall, those of one component first, then those that are least
/// open and go on most evenly. What is left is paired in the same way, then faces oriented alike.
/// No pair passes through another. Faces of zero area have no angle and come last.
///
/// @complexity O(n log n) for n that alternate; above 32 faces none are joined that are oriented
/// alike.
[[nodiscard]] EdgePairing pair_round_edge(const Vec3& a, const Vec3& b,
                                          std::span<const FaceAtEdge> faces);

}  // namespace meshalyzer
