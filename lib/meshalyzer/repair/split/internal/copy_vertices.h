#pragma once

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/split/internal/incident_faces.h"

#include <span>

namespace meshalyzer {

/// Tells whether so many fans meet at a vertex, as where a file was overwritten with zeros, that
/// copies of it would do harm: each two of them would touch, and no other pass could go on with all
/// these pairs.
///
/// @param fans  The fans of the faces at the vertex, as find_fans_at() returns them.
[[nodiscard]] bool are_too_many_fans(std::span<const Index> fans);

/// Gives each fan beyond the first at each vertex a copy of the vertex.
///
/// @param fans      The fan of each incident face, as find_fans_at() returns them, entry after
/// entry.
/// @param together  Sets of entries that are to be one operation; sets that change the same face
/// are joined.
/// @return          One operation for each set with something to cut, in order of their lowest
/// vertices.
[[nodiscard]] Edits copy_vertices(const Soup& soup, const IncidentFaces& incident,
                                  std::span<const Index> fans, DisjointSets together);

}  // namespace meshalyzer
