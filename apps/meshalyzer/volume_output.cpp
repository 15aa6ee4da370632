#include "volume_output.h"

#include "meshalyzer/base/numbers.h"

#include <ostream>

namespace meshalyzer {

void VolumeOutput::finish(const SetAnalysis* set) {
  if (set == nullptr || set->meshes == 0) {
    return;
  }
  if (!set->volume.reason.empty()) {
    streams_.err << "meshalyzer: total volume: " << set->volume.reason << '\n';
  }
  streams_.out << (set->volume.value ? shortest(*set->volume.value) : "undefined") << '\n';
}

}  // namespace meshalyzer
