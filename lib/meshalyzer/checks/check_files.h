#pragma once

#include "meshalyzer/checks/criteria.h"
#include "meshalyzer/checks/finding.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace meshalyzer {

/// A file to check, and against what.
struct CheckJob {
  /// "-" is standard input.
  std::string path;
  /// What the result calls the file; also says the format of standard input.
  std::string name;
  CheckCriteria criteria;
};

/// Checks files, each for itself, in parallel, and large ones inside; at most a few at a time, as
/// memory allows. What is told does not depend on the number of threads, nor on the memory limit.
///
/// @param memory_limit  Bytes to stay below where the largest few files allow it.
/// @param tell          Hears of each file as soon as it and all before it are done, in order;
/// false ends the work.
/// @return              Whether all files were told of.
[[nodiscard]] bool check_files(const std::vector<CheckJob>& jobs, std::uint64_t memory_limit,
                               const std::function<bool(const FileFindings&)>& tell);

}  // namespace meshalyzer
