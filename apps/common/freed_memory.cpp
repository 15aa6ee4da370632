#include "freed_memory.h"

#include <limits>
#include <malloc.h>

namespace meshalyzer {
namespace {

/// The size from which on files are large: a mesh of about 250,000 faces as text.
constexpr std::size_t kLargeFiles = std::size_t{16} << 20;

/// The default of glibc for the number of blocks that are returned.
constexpr int kMostReturnedBlocks = 65'536;
/// So much of what is free at the end of the heap is kept where large blocks are returned.
constexpr int kKeptEnd = 24 << 20;

}  // namespace

void return_large_blocks(int least_mib) {
  ::mallopt(M_MMAP_MAX, kMostReturnedBlocks);
  ::mallopt(M_MMAP_THRESHOLD, least_mib << 20);
  ::mallopt(M_TRIM_THRESHOLD, kKeptEnd);
}

void keep_freed_memory_if_small(std::size_t n_bytes) {
  if (n_bytes >= kLargeFiles) return return_large_blocks(4);
  ::mallopt(M_MMAP_MAX, 0);
  ::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}

}  // namespace meshalyzer
