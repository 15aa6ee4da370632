#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <vector>

namespace meshalyzer {

/// Returns the faces of the complex that use a file vertex, by ascending record.
[[nodiscard]] std::vector<Index> faces_at(const CutMesh& cut, Index vertex);

}  // namespace meshalyzer
