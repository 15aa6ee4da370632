#include "meshalyzer/mesh/orphans.h"

#include <cstdint>

namespace meshalyzer {

std::vector<Index> find_orphan_vertices(const Soup& soup, std::span<const Index> repeated) {
  std::vector<std::uint8_t> is_known(soup.n_vertices(), 0);
  for (const Triangle& t : soup.triangles) {
    for (const Index v : t) {
      if (v != kNoIndex) is_known[v] = 1;
    }
  }
  for (const Index record : repeated) is_known[record] = 1;
  std::vector<Index> orphans;
  for (Index v = 0; v < is_known.size(); ++v) {
    if (is_known[v] == 0) orphans.push_back(v);
  }
  return orphans;
}

}  // namespace meshalyzer
