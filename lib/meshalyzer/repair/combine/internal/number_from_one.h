#pragma once

#include "meshalyzer/repair/edits/tracked_mesh.h"

namespace meshalyzer {

/// Numbers the records 1, 2, ..., n where the format has numbers.
void number_from_one(TrackedMesh& mesh);

}  // namespace meshalyzer
