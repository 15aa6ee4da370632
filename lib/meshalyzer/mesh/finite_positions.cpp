#include "meshalyzer/mesh/finite_positions.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace meshalyzer {

bool has_finite_positions(const Soup& soup) {
  const auto parts = map_chunks<char>(soup.n_vertices(), [&](Chunk chunk) {
    const auto begin = soup.positions.begin();
    return static_cast<char>(std::all_of(begin + static_cast<std::ptrdiff_t>(chunk.begin),
                                         begin + static_cast<std::ptrdiff_t>(chunk.end),
                                         [](const Vec3& p) { return p.allFinite(); }));
  });
  return std::all_of(parts.begin(), parts.end(), [](char finite) { return finite != 0; });
}

void require_finite_positions(const Soup& soup) {
  if (!has_finite_positions(soup)) throw InvalidArgument("a position of the mesh is not finite");
}

}  // namespace meshalyzer
