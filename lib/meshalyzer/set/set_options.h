#pragma once

#include "meshalyzer/set/earlier_findings.h"
#include "meshalyzer/set/request.h"
#include "meshalyzer/set/shard.h"

#include <cstdint>

namespace meshalyzer {

/// Tells how to analyse files, as a set or each for itself.
struct SetOptions {
  Request request;
  /// Keep the files in the analyses, for reports that show places.
  bool keep_soup = false;
  /// Keep the files and what was built for them, where pictures are drawn as soon as a mesh is
  /// analysed.
  bool keep_mesh = false;
  /// Bytes to stay below where the largest few meshes allow it; objects are read again when they
  /// had to be forgotten.
  std::uint64_t memory_limit = 0;
  Shard shard;
  /// Findings that need not be looked for again, if there are any; they must outlive the run.
  const EarlierFindings* earlier = nullptr;
};

}  // namespace meshalyzer
