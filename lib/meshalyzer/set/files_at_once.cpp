#include "meshalyzer/set/files_at_once.h"

#include "meshalyzer/base/bytes.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/set/file_stamp.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <iterator>

namespace meshalyzer {
namespace {

/// The approximate number of bytes of memory that the analysis takes for each byte of a file.
constexpr std::uint64_t kMemoryPerFileByte = 12;

/// Returns the size of a file, or the approximate unpacked size of a gzipped one, which its last
/// four bytes give.
std::uint64_t content_bytes(const std::string& path) {
  const std::uint64_t bytes = stamp_of(path).bytes;
  std::array<char, sizeof(std::uint32_t)> size{};
  if (is_gzip_name(path) && bytes >= size.size()) {
    std::ifstream file(path, std::ios::binary);
    file.seekg(-static_cast<std::streamoff>(size.size()), std::ios::end);
    file.read(size.data(), size.size());
  }
  return std::max<std::uint64_t>(bytes, load<std::uint32_t>(size.data(), std::endian::little));
}

}  // namespace

std::size_t n_files_at_once(const std::vector<std::string>& paths, std::uint64_t memory_limit) {
  std::vector<std::uint64_t> bytes;
  std::transform(paths.begin(), paths.end(), std::back_inserter(bytes), content_bytes);
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
