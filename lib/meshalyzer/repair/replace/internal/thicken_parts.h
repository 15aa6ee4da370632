#pragma once

#include "meshalyzer/repair/pass.h"

#include <span>

namespace meshalyzer {

/// Makes thin solids of components as thicken_sheets() does, whatever they bound: what they
/// enclosed is hollow then.
///
/// @param face_keys       The keys of faces, ascending: their components become thin solids.
/// @param separable_keys  The keys of separable faces, ascending, see thicken().
/// @param thickness       The thickness of the solid over a flat surface; a length above 0.
[[nodiscard]] PassResult thicken_parts(const PassInput& input, std::span<const Index> face_keys,
                                       std::span<const Index> separable_keys, double thickness);

}  // namespace meshalyzer
