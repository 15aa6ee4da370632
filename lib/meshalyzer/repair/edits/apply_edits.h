#pragma once

#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <cstdint>
#include <span>

namespace meshalyzer {

/// Applies the edits, except those of skipped operations, and returns the changed mesh.
///
/// Elements that no operation names stay bit for bit: positions, ids, order, groups, normals. Added
/// vertices come last; an added face comes last of the group it joins. If the format names ids,
/// added elements get those after the largest; else ids follow the order. Vertices that lose their
/// last face are dropped with it. If each vertex has a normal of its own (PLY, OFF), an added one
/// gets that of the vertex it copies, else the mean of those of the other vertices of its faces.
/// Lines of records (Soup::vertex_lines, face_lines) and torn lines are dropped, because no file
/// holds the result.
///
/// @param skipped  #operations, non-zero for those to be left out; if empty, none is.
/// @complexity     O(#V + #F + edits).
[[nodiscard]] TrackedMesh apply_edits(const TrackedMesh& tracked, const Edits& edits,
                                      std::span<const std::uint8_t> skipped = {});

}  // namespace meshalyzer
