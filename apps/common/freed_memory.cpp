#include "freed_memory.h"

#include <malloc.h>

namespace meshalyzer {

void return_large_blocks() {
  // The system fills a block with zeros when it gives it again: from this size on that costs a
  // repair with many rounds less than a twentieth of its time.
  constexpr int kLargeBlock = 4 << 20;
  ::mallopt(M_MMAP_THRESHOLD, kLargeBlock);
}

}  // namespace meshalyzer
