#pragma once

#include "output.h"
#include "run.h"
#include "streams.h"

#include <memory>
#include <vector>

namespace meshalyzer {

/// Returns the reports that a run makes, in the order in which they receive findings.
/// @throws IoError if one cannot be written.
[[nodiscard]] std::vector<std::unique_ptr<Output>> outputs_of(const Run& run, Streams streams);

}  // namespace meshalyzer
