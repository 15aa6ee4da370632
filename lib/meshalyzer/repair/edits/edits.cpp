#include "meshalyzer/repair/edits/edits.h"

namespace meshalyzer {

std::vector<std::uint8_t> which_overflow(const Edits& edits) {
  std::vector<std::uint8_t> overflows(edits.n_operations, 0);
  for (const Edits::MovedVertex& moved : edits.moved_vertices) {
    if (!moved.to.allFinite()) overflows[moved.op] = 1;
  }
  for (const Edits::AddedVertex& added : edits.added_vertices) {
    if (!added.position.allFinite()) overflows[added.op] = 1;
  }
  return overflows;
}

}  // namespace meshalyzer
