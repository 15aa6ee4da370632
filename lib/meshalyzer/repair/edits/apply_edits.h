#pragma once

#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <cstdint>
#include <span>

namespace meshalyzer {

/// Applies the edits, except those of skipped operations, and returns the changed mesh.
///
/// What no operation names stays bit for bit: positions, ids, order, groups, normals. Added
/// vertices come last; an added face comes last of the group it joins. Where the format names ids,
/// what is added gets those after the largest; else ids follow the order. Vertices that lose their
/// last face go with it. Where each vertex has a normal of its own (PLY, OFF), an added one gets
/// that of the vertex it copies, else the mean of those of the other vertices of its faces.
/// Lines of records (Soup::vertex_lines, face_lines) and torn lines are dropped, because no file
/// holds the result.
///
/// @param skipped  #operations, non-zero for those to be left out; empty: none is.
/// @complexity     O(#V + #F + edits).
[[nodiscard]] TrackedMesh apply_edits(const TrackedMesh& tracked, const Edits& edits,
                                      std::span<const std::uint8_t> skipped = {});

}  // namespace meshalyzer
