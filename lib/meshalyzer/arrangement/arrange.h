#pragma once

#include "meshalyzer/arrangement/arrangement.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace meshalyzer {

/// Cuts a soup along its self-intersections.
///
/// It finds first the points where the faces of a pair meet, then those where segments cross inside
/// a face, always from the input's vertices. Then it triangulates each face, or cluster of faces
/// that overlap in one plane, with its points and segments. All decisions are exact.
///
/// @param pairs  All intersecting pairs, as find_self_intersections() returns them, including
///               touching and unwelded ones: everything that such faces have in common becomes
///               vertices and edges.
/// @return       The arrangement, which is the same for any number of threads.
/// @throws InvalidArgument if a pair names a face outside the complex.
/// @complexity   O(#F + n log n) for n points, plus the comparison of the segments in a face whose
///               boxes meet.
[[nodiscard]] Arrangement arrange(const Soup& soup, std::span<const IntersectingPair> pairs);

/// What ends the cutting of a soup early.
struct ArrangeLimits {
  /// The maximum number of pieces, and of nodes beside the vertices.
  std::size_t max_pieces = std::numeric_limits<std::size_t>::max();
  /// The maximum memory for the digits of the exact coordinates of points on edges of faces, and
  /// again of those inside faces, in bytes: points have thousands of digits if some coordinates of
  /// the soup are 1e150 and others 1.
  std::size_t max_digit_bytes = std::numeric_limits<std::size_t>::max();
  /// The maximum number of times that segments cross each other inside faces, added up over the
  /// faces. Each may be a point of its own, whose exact coordinates take 400 bytes.
  std::size_t max_crossings = std::numeric_limits<std::size_t>::max();
  /// Called now and then, from any thread; once it returns true, cutting ends.
  StopQuery wants_to_stop = {};
};

/// Cuts a soup along its self-intersections, within limits. Faces are not even cut if there are too
/// many points to cut them at: each adds a piece to every face that it lies on, or two inside it.
///
/// @return  The same as arrange(), or nothing if there would be more, or if it was told to stop.
[[nodiscard]] std::optional<Arrangement> arrange_within(const Soup& soup,
                                                        std::span<const IntersectingPair> pairs,
                                                        const ArrangeLimits& limits);

/// Finds the intersecting pairs of a soup and cuts it along them.
///
/// @throws InvalidArgument  as build(); and if a position is not finite.
[[nodiscard]] Arrangement arrange(const Soup& soup);

}  // namespace meshalyzer
