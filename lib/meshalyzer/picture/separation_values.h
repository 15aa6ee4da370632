#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/set/separation.h"

#include <vector>

namespace meshalyzer {

/// Returns the distance of each vertex record to other objects, for a field of the mesh.
///
/// @param separation  The separation of this soup.
/// @return            #V: the distances, NaN for vertices that no face of the complex uses, and
///     where no point was found.
/// @complexity        O(#V + #F).
[[nodiscard]] std::vector<double> separation_values(const Soup& soup,
                                                    const ObjectSeparation& separation);

}  // namespace meshalyzer
