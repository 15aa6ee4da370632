#pragma once

#include "meshalyzer/arrangement/arrangement.h"
#include "meshalyzer/mesh/soup.h"

#include <cstdint>
#include <string>

namespace meshalyzer::test {

/// Returns the first fault of an arrangement of a soup, judged over the rationals and by brute
/// force; empty if there is none. Faults are:
///
/// - two pieces have more in common than their vertices and edges by index;
/// - a piece lies outside a face that it is said to be of, or is turned the other way than said;
/// - the area vectors of a face's pieces do not add up to that of the face;
/// - a vertex is not the nearest double of its exact place, or is at the place of another;
/// - a face that was not cut is not its own piece;
/// - an edge that is said to lie on a curve is no edge of a piece.
[[nodiscard]] std::string arrangement_fault(const Soup& soup, const Arrangement& arrangement);

/// Returns the first of `n` random points at which the winding number of the pieces differs from
/// that of the faces; empty if there is none. The soup must be a closed chain with coordinates up
/// to some ten.
[[nodiscard]] std::string winding_fault(const Soup& soup, const Arrangement& arrangement,
                                        std::size_t n);

}  // namespace meshalyzer::test
