#include "freed_memory.h"

#include <malloc.h>

namespace meshalyzer {

void return_large_blocks() {
  // Mapping a block costs as much as writing a few pages, which does not show from this size on.
  constexpr int kLargeBlock = 4 << 20;
  ::mallopt(M_MMAP_THRESHOLD, kLargeBlock);
}

}  // namespace meshalyzer
