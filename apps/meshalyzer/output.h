#pragma once

#include "meshalyzer/set/run_listener.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// A report that is made while a run goes on.
class Output : public RunListener {
 public:
  /// Ends the report. It is not called if the run was stopped: an incomplete report must not
  /// replace an old one.
  ///
  /// @param set  The findings about the set, or null if the files are no set.
  virtual void finish(const SetAnalysis* set) = 0;
};

}  // namespace meshalyzer
