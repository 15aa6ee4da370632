#pragma once

#include "meshalyzer/repair/pass.h"

namespace meshalyzer {

/// Moves the components that are open, or have faces that intersect, outward: each by a distance of
/// its own, between `least` and twice that, and each vertex along the normals of its faces, so that
/// flat walls stay flat. Where walls touch, or are some roundings apart, which way each of them was
/// rounded decides how they intersect. Moved ones overlap where they faced each other, and are
/// apart where they faced the same way.
///
/// A vertex at a sharp edge or corner moves farther, by twice the distance of its component at
/// most.
///
/// @param least  A length above 0.
/// @complexity   O(#E log #F + pairs), and the search for these if nobody has asked for them.
[[nodiscard]] PassResult offset_parts(const PassInput& input, double least);

}  // namespace meshalyzer
