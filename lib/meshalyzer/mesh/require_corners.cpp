#include "meshalyzer/mesh/require_corners.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace meshalyzer {

void require_corners(const Soup& soup) {
  const std::size_t n_vertices = soup.n_vertices();
  const auto is_outside = [&](Index v) { return v >= n_vertices && v != kNoIndex; };
  const std::vector<Index> wrong = parallel_filter(soup.n_faces(), [&](Index face) {
    return std::ranges::any_of(soup.triangles[face], is_outside);
  });
  if (wrong.empty()) return;
  const Triangle& t = soup.triangles[wrong.front()];
  throw InvalidArgument("face " + std::to_string(wrong.front()) + " names vertex " +
                        std::to_string(*std::ranges::find_if(t, is_outside)) + " of " +
                        std::to_string(n_vertices));
}

}  // namespace meshalyzer
