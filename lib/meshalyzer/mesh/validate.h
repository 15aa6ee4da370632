#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/mesh/soup.h"

#include <string>
#include <vector>

namespace meshalyzer {

/// Checks OpenMesh's invariants and that the side table glues the mesh back to exactly the file's
/// complex.
///
/// The invariants are: next and previous are inverse; opposite half-edges join the same two
/// vertices; every face is a loop of three; every border is a closed loop; each vertex has one fan,
/// and an outgoing half-edge on the border where it has one; the cut edges of the side table are
/// borders of the mesh between the vertices they should join.
///
/// @return One sentence for each fault, at most `max_messages`; empty if there is none.
/// @complexity O(#V + #F log #F).
[[nodiscard]] std::vector<std::string> validate(const CutMesh& cut, const Soup& soup,
                                                std::size_t max_messages = 10);

}  // namespace meshalyzer
