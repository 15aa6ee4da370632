#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/topology/components.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// @return  #components: 1 for those without a border, whose edges all have two faces.
[[nodiscard]] std::vector<std::uint8_t> which_are_closed(const CutMesh& cut,
                                                         const Components& components);

/// Tells for each component whether its surface bounds a solid: whether at least half of its area
/// separates inside from outside. A face separates if the winding numbers of its component on its
/// two sides are nearer to 1 and 0, as of a closed surface, than to 1/2 and -1/2, as of a flat
/// sheet, or to the negatives of these. So a hemisphere bounds a solid, and a long tube does, but a
/// sheet (terrain, a cloth, half a face scan) or a short ring bounds none.
///
/// A component whose orientation is inconsistent is judged as if its flipped edges were repaired,
/// if they can be. A large component is judged by a few hundred faces.
///
/// @param components     The result of find_components() or find_edge_components().
/// @param wants_to_stop  Called for each component, from any thread; once it returns true, no
/// further open component counts as one that bounds a solid. May be empty.
/// @return               #components: 1 for those that bound a solid; closed ones (no edge has only
/// one face) always do.
/// @complexity           O(#E), and O(#F log #F) for open components.
[[nodiscard]] std::vector<std::uint8_t> bounds_solid(const PreparedMesh& mesh,
                                                     const Components& components,
                                                     const StopQuery& wants_to_stop = {});

}  // namespace meshalyzer
