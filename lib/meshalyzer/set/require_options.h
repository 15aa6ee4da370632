#pragma once

#include "meshalyzer/set/set_options.h"

namespace meshalyzer {

/// @throws InvalidArgument  if a length is none, or the angle of the cone outside 0 ... 90.
void require_valid(const SeparationOptions& options);

/// @throws InvalidArgument  for such options of the separation; if the time limit is negative or
/// NaN; and if there is no shard of this number.
void require_valid(const SetOptions& options);

}  // namespace meshalyzer
