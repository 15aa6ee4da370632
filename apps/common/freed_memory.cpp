#include "freed_memory.h"

#include <malloc.h>

namespace meshalyzer {

void return_large_blocks(int least_mib) {
  ::mallopt(M_MMAP_THRESHOLD, least_mib << 20);
}

}  // namespace meshalyzer
