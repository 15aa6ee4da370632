#include "meshalyzer/analysis/solids.h"

#include "meshalyzer/prepared/shells.h"

#include <cstdint>

namespace meshalyzer {
namespace {

bool bounds_a_solid(const ComponentAnalysis& c) {
  return c.closed && c.manifold && c.consistent.value_or(false);
}

}  // namespace

void analyze_solids(const SolidsInput& input, std::vector<ComponentAnalysis>& analyses) {
  const std::size_t n = input.components.count;
  std::vector<std::uint8_t> is_shell(n);
  std::vector<Box3> boxes(n);
  for (std::size_t c = 0; c < n; ++c) {
    is_shell[c] = bounds_a_solid(analyses[c]) ? 1 : 0;
    boxes[c] = analyses[c].bounding_box;
  }
  const std::vector<Shell> shells = find_shells({.cut = input.cut,
                                                 .tree = input.tree,
                                                 .components = input.components,
                                                 .is_shell = is_shell,
                                                 .boxes = boxes,
                                                 .pairs = input.pairs});
  for (std::size_t c = 0; c < n; ++c) {
    analyses[c].volume = shells[c].volume;
    analyses[c].outward = shells[c].outward;
    if (shells[c].inside != kNoIndex) {
      analyses[c].inside = shells[c].inside;
    }
  }
}

}  // namespace meshalyzer
