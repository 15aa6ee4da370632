#include "large_blocks.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <malloc.h>
#include <new>
#include <sys/mman.h>

namespace meshalyzer {
namespace {

/// From this size on huge pages pay, though some of the block is in small ones.
constexpr std::size_t kLargeBlock = std::size_t{4} << 20U;

/// The size of huge pages on most processors.
constexpr std::size_t kHugePage = std::size_t{2} << 20U;

/// Allocates a block; asks for huge pages for all of a large one but its end, so that it takes no
/// more memory than it would in small pages.
void* allocate(std::size_t size, std::size_t alignment) {
  const bool is_large = size >= kLargeBlock;
  void* block = nullptr;
  const int error = ::posix_memalign(&block, is_large ? std::max(alignment, kHugePage) : alignment,
                                     std::max(size, std::size_t{1}));
  if (error != 0) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  // A system that has no huge pages says so, and gives small ones.
  if (is_large) ::madvise(block, size / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
  return block;
}

}  // namespace

void return_large_blocks(int least_mib) {
  ::mallopt(M_MMAP_THRESHOLD, least_mib << 20);
}

}  // namespace meshalyzer

// All containers take their memory here; the other forms of new and delete call these.

void* operator new(std::size_t size) {
  return meshalyzer::allocate(size, alignof(std::max_align_t));
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  return meshalyzer::allocate(size, static_cast<std::size_t>(alignment));
}

// Sanitizers have these two of their own, which would not fit the operators delete below.

void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void* operator new(std::size_t size, std::align_val_t alignment,
                   const std::nothrow_t& /*tag*/) noexcept {
  try {
    return operator new(size, alignment);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void operator delete(void* block) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t /*size*/) noexcept {
  std::free(block);
}

void operator delete(void* block, std::align_val_t /*alignment*/) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  std::free(block);
}
