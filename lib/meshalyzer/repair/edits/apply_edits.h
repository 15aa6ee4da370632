#pragma once

#include "meshalyzer/repair/edits/draft.h"
#include "meshalyzer/repair/edits/edits.h"

#include <cstdint>
#include <span>

namespace meshalyzer {

/// Makes the changes, all but those of some operations.
///
/// What no operation names stays bit for bit: positions, ids, order, groups, normals. Added
/// vertices come last; an added face comes last of the group it joins. Where the format names ids,
/// what is added gets those after the largest; else ids follow the order. Vertices that lose their
/// last face go with it. Where each vertex has a normal of its own (PLY, OFF), an added one gets
/// that of the vertex it copies, else the mean of those of the other vertices of its faces.
/// Lines of records (Soup::vertex_lines, face_lines) and torn lines are forgotten: the result is of
/// no file.
///
/// @param skipped  #operations, non-zero for those to be left out; empty: none is.
/// @complexity     O(#V + #F + edits).
[[nodiscard]] Draft apply_edits(const Draft& draft, const Edits& edits,
                                std::span<const std::uint8_t> skipped = {});

}  // namespace meshalyzer
