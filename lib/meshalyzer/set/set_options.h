#pragma once

#include "meshalyzer/set/earlier_findings.h"
#include "meshalyzer/set/request.h"
#include "meshalyzer/set/shard.h"

#include <cstdint>

namespace meshalyzer {

/// The options for the analysis of files, as a set or independently.
struct SetOptions {
  Request request;
  /// Keeps the files in the analyses, for reports that show positions.
  bool keep_soup = false;
  /// Keeps the prepared meshes in the analyses, for pictures that are drawn at once.
  bool keep_mesh = false;
  /// The memory limit in bytes, which is kept if the largest few meshes allow it; dropped objects
  /// are read again.
  std::uint64_t memory_limit = 0;
  Shard shard;
  /// The findings of earlier runs, or null; they must outlive the run.
  const EarlierFindings* earlier = nullptr;
};

}  // namespace meshalyzer
