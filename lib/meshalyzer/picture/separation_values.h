#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/set/separation.h"

#include <vector>

namespace meshalyzer {

// Private to the picture module and the programs.

/// The distances of all vertex records.
///
/// @param separation  Of this soup.
/// @return            #V; NaN for vertices that no face of the complex uses, and where nothing was
///                    found.
/// @complexity        O(#V + #F).
[[nodiscard]] std::vector<double> separation_values(const Soup& soup,
                                                    const ObjectSeparation& separation);

}  // namespace meshalyzer
