#include "meshalyzer/set/files_at_once.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/set/file_stamp.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace meshalyzer {
namespace {

/// About the bytes of memory that the analysis of a file takes for each byte of it.
constexpr std::uint64_t kMemoryPerFileByte = 12;

}  // namespace

std::size_t n_files_at_once(const std::vector<std::string>& paths, std::uint64_t memory_limit) {
  std::vector<std::uint64_t> bytes;
  std::transform(paths.begin(), paths.end(), std::back_inserter(bytes),
                 [](const std::string& path) { return stamp_of(path).bytes; });
  std::sort(bytes.begin(), bytes.end(), std::greater<>());
  const std::size_t most = std::min(2 * max_threads(), bytes.size());
  std::uint64_t memory = 0;
  std::size_t n = 0;
  while (n < most && (memory += kMemoryPerFileByte * bytes[n]) <= memory_limit) {
    ++n;
  }
  return std::max<std::size_t>(1, n);
}

}  // namespace meshalyzer
