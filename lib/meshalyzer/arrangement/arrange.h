#pragma once

#include "meshalyzer/arrangement/arrangement.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/spatial/intersecting_pair.h"

namespace meshalyzer {

/// Cuts a soup along its self-intersections.
///
/// First all points are found where the faces of a pair meet, then those where segments cross
/// inside a face, always from the input's vertices; then each face, or cluster of faces that
/// overlap in one plane, is triangulated with its points and segments. All decisions are exact.
///
/// @param pairs  All that intersect, as find_self_intersections() gives them. Touching and unwelded
///               ones count too: all that such faces have in common becomes vertices and edges.
/// @return       The same for any number of threads.
/// @throws InvalidArgument if a pair names a face that is in no complex.
/// @complexity   O(#F + n log n) for n points, and what crossings of segments in a face cost: those
/// whose boxes meet are compared.
[[nodiscard]] Arrangement arrange(const Soup& soup, std::span<const IntersectingPair> pairs);

/// Finds the pairs too.
[[nodiscard]] Arrangement arrange(const Soup& soup);

}  // namespace meshalyzer
