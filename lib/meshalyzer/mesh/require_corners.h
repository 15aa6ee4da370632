#pragma once

#include "meshalyzer/mesh/soup.h"

namespace meshalyzer {

/// Refuses a soup whose faces name vertices that it does not have. Whatever reads the corners of a
/// soup that a caller has made calls this first.
///
/// @throws InvalidArgument  if a corner is neither kNoIndex nor an index into positions.
/// @complexity  O(#F).
void require_corners(const Soup& soup);

}  // namespace meshalyzer
