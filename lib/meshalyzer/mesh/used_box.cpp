#include "meshalyzer/mesh/used_box.h"

#include "meshalyzer/base/parallel.h"

namespace meshalyzer {

Box3 used_box(const Soup& soup) {
  const auto boxes = map_chunks<Box3>(soup.n_faces(), [&](Chunk chunk) {
    Box3 box;
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      const Triangle& t = soup.triangles[f];
      if (!is_in_complex(t)) continue;
      for (const Index v : t) box.extend(soup.positions[v]);
    }
    return box;
  });
  Box3 box;
  for (const Box3& part : boxes) box.extend(part);
  return box;
}

double used_extent(const Soup& soup) {
  const Box3 box = used_box(soup);
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

}  // namespace meshalyzer
