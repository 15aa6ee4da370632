#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meshalyzer {

/// How many files are worked on at the same time: as many as the largest of them leave memory for,
/// at least one.
///
/// @param memory_limit  Bytes.
[[nodiscard]] std::size_t n_files_at_once(const std::vector<std::string>& paths,
                                          std::uint64_t memory_limit);

}  // namespace meshalyzer
