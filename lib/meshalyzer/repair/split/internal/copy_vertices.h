#pragma once

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/split/internal/incident_faces.h"

#include <span>

namespace meshalyzer {

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
