#pragma once

#include "meshalyzer/mesh/soup.h"

namespace meshalyzer {

/// Refuses a soup that contradicts itself. Whatever reads a soup that a caller has made calls this
/// first.
///
/// @throws InvalidArgument  if a corner is neither kNoIndex nor an index into positions, or one of
/// normals not into those; if a list with an entry for each record has too few; or if a missing
/// reference or a group begins at no face, or the groups are not in file order.
/// @complexity  O(#F).
void require_records(const Soup& soup);

}  // namespace meshalyzer
