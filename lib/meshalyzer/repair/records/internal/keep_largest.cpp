#include "meshalyzer/repair/records/internal/keep_largest.h"

#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace meshalyzer {

PassResult keep_largest(const PassInput& input, std::size_t n) {
  const CutMesh& cut = input.mesh.cut();
  const Components components = find_components(cut);
  PassResult result;
  if (components.count <= n) return result;
  std::vector<std::size_t> size(components.count, 0);
  for (const Index c : components.of_face) ++size[c];
  std::vector<std::size_t> order(components.count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Components are numbered by their lowest face.
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
  std::vector<std::uint8_t> is_kept(components.count, 0);
  for (std::size_t i = 0; i < n; ++i) is_kept[order[i]] = 1;
  const Index op = result.edits.begin_operation();
  for (std::size_t f = 0; f < components.of_face.size(); ++f) {
    if (is_kept[components.of_face[f]] == 0) {
      result.edits.removed_faces.push_back({op, cut.side.faces[f]});
    }
  }
  return result;
}

}  // namespace meshalyzer
