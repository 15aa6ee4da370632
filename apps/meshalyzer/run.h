#pragma once

#include "exit_code.h"
#include "inputs.h"
#include "meshalyzer/set/earlier_findings.h"
#include "meshalyzer/set/request.h"
#include "meshalyzer/set/run_listener.h"
#include "options.h"
#include "picture_paths.h"
#include "streams.h"

namespace meshalyzer {

/// The input of one call of the program. It only refers to it.
struct Run {
  const Options& options;
  const Inputs& inputs;
  const Request& request;
  const PicturePaths& pictures;
  /// The findings of earlier runs; may be null.
  const EarlierFindings* earlier = nullptr;
  /// The listener that stores the findings; may be null.
  RunListener* journal = nullptr;
};

/// Analyses the files, and reports findings as they come.
[[nodiscard]] ExitCode carry_out(const Run& run, Streams streams);

}  // namespace meshalyzer
