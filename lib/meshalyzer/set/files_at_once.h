#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meshalyzer {

/// Returns the number of files to analyse at a time: as many as fit into memory even if they are
/// the largest, at least one.
///
/// @param memory_limit  The limit in bytes.
[[nodiscard]] std::size_t n_files_at_once(const std::vector<std::string>& paths,
                                          std::uint64_t memory_limit);

}  // namespace meshalyzer
