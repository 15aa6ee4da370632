#pragma once

#include "meshalyzer/repair/holes/internal/fill_memory.h"
#include "meshalyzer/repair/holes/internal/triangulation_memory.h"

namespace meshalyzer {

/// What is known of holes from the meshes that a repair has had. Nothing depends on it but the
/// time.
struct HoleMemory {
  FailedFillings failed;
  TriangulationMemory triangulations;
};

}  // namespace meshalyzer
