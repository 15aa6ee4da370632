#pragma once

#include "meshalyzer/arrangement/arrangement.h"
#include "meshalyzer/mesh/soup.h"

#include <cstdint>
#include <string>

namespace meshalyzer::test {

/// What is wrong with an arrangement of a soup, judged over the rationals and by brute force; empty
/// where it is right:
///
/// - two pieces have more in common than their vertices and edges by index;
/// - a piece lies outside a face that it is said to be of, or is turned the other way than said;
/// - the area vectors of a face's pieces do not add up to that of the face;
/// - a vertex is not the nearest double of its exact place, or is at the place of another;
/// - a face that was not cut is not its own piece;
/// - an edge that is said to lie on a curve is no edge of a piece.
[[nodiscard]] std::string arrangement_fault(const Soup& soup, const Arrangement& arrangement);

/// The first of `n` random points at which the winding number of the pieces is not that of the
/// faces; empty where there is none. Only for closed chains with coordinates up to some ten.
[[nodiscard]] std::string winding_fault(const Soup& soup, const Arrangement& arrangement,
                                        std::size_t n);

}  // namespace meshalyzer::test
