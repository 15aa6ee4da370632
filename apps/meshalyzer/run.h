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
  /// The findings that are known already; may be null.
  const EarlierFindings* earlier = nullptr;
  /// Keeps what is found; may be null.
  RunListener* journal = nullptr;
};

/// Has the files analysed, and tells what is found as it is found.
[[nodiscard]] ExitCode carry_out(const Run& run, Streams streams);

}  // namespace meshalyzer
