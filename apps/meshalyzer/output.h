#pragma once

#include "meshalyzer/set/run_listener.h"
#include "meshalyzer/set/set_analysis.h"

namespace meshalyzer {

/// A report that is made while a run goes on.
class Output : public RunListener {
 public:
  /// Ends the report. Not called where the run was stopped: then there is no whole report to take
  /// the place of an old one.
  ///
  /// @param set  Null where the files are no set.
  virtual void finish(const SetAnalysis* set) = 0;
};

}  // namespace meshalyzer
