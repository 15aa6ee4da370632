#pragma once

#include "meshalyzer/repair/holes/internal/hole_memory.h"
#include "meshalyzer/repair/split/internal/parting_memory.h"

namespace meshalyzer {

/// What passes know from the meshes that a repair has had.
struct PassMemory {
  HoleMemory holes;
  FailedPartings failed_partings;
};

}  // namespace meshalyzer
