#pragma once

#include "output.h"
#include "streams.h"

namespace meshalyzer {

/// Prints only the total volume of a set (-v).
class VolumeOutput : public Output {
 public:
  explicit VolumeOutput(Streams streams) : streams_(streams) {}

  void finish(const SetAnalysis* set) override;

 private:
  Streams streams_;
};

}  // namespace meshalyzer
