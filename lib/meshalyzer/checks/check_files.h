#pragma once

#include "meshalyzer/checks/criteria.h"
#include "meshalyzer/checks/finding.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace meshalyzer {

/// A file to check, and the criteria.
struct CheckJob {
  /// The path of the file; "-" is standard input.
  std::string path;
  /// The name of the file in the result, which also determines the format of standard input.
  std::string name;
  CheckCriteria criteria;
};

/// Checks files independently of each other: a few at a time in parallel, as memory allows, and
/// large ones with several threads each. The findings depend neither on the number of threads nor
/// on the memory limit.
///
/// @param memory_limit  The memory limit in bytes, which is kept if the largest few files allow it.
/// @param on_file       Receives each file in order, as soon as it and all before it are done;
///     false ends the work.
/// @return              True if all files were reported.
/// @throws InvalidArgument  as check_mesh(); and if on_file is null.
[[nodiscard]] bool check_files(const std::vector<CheckJob>& jobs, std::uint64_t memory_limit,
                               const std::function<bool(const FileFindings&)>& on_file);

}  // namespace meshalyzer
