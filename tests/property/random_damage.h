#pragma once

#include "soups_to_try.h"

#include <cstdint>

namespace meshalyzer {

/// A closed surface that was damaged in one to five ways at random, in order: holes, turned,
/// repeated, thin, loose and torn faces, open seams, solids and fins that hang on a vertex or an
/// edge, orphans, false records. The name tells of which shape and how.
///
/// The same seed gives the same mesh on every platform.
[[nodiscard]] NamedSoup damaged_mesh(std::uint32_t seed);

/// The closed surfaces that these are made of: nothing is wrong with them.
[[nodiscard]] const std::vector<NamedSoup>& good_meshes();

}  // namespace meshalyzer
