#include "meshalyzer/picture/separation_values.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace meshalyzer {

std::vector<double> separation_values(const Soup& soup, const ObjectSeparation& separation) {
  std::vector<std::uint8_t> is_used(soup.n_vertices(), 0);
  for (const Triangle& t : soup.triangles) {
    if (is_in_complex(t)) {
      for (const Index v : t) {
        is_used[v] = 1;
      }
    }
  }
  std::vector<double> values(soup.n_vertices(), std::numeric_limits<double>::quiet_NaN());
  auto next = separation.distances.begin();
  for (std::size_t v = 0; v < values.size() && next != separation.distances.end(); ++v) {
    if (is_used[v] != 0) {
      values[v] = *next++;
    }
  }
  return values;
}

}  // namespace meshalyzer
