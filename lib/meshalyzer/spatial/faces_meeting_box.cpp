#include "meshalyzer/spatial/faces_meeting_box.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns a point in the coordinates of the tree's boxes, which are within -1 ... 1 except for
/// rounding; points far outside are brought nearer, because empty boxes are at infinity.
std::array<float, 3> mapped(const FaceTree& tree, const Vec3& point) {
  std::array<float, 3> result = tree.map(point);
  for (float& x : result) x = std::clamp(x, -4.0F, 4.0F);
  return result;
}

}  // namespace

std::vector<Index> find_faces_meeting(const FaceTree& tree, const Box3& box) {
  if (tree.n_faces() == 0) return {};
  const TreeBox wanted{mapped(tree, box.min()), mapped(tree, box.max())};
  std::vector<std::size_t> nodes{0};
  for (std::size_t level = tree.n_levels(); level-- > 0;) {
    std::vector<std::size_t> below;
    for (const std::size_t i : nodes) {
      for (unsigned bits = tree.node(level, i).meeting(wanted); bits != 0; bits &= bits - 1) {
        below.push_back(8 * i + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
    nodes = std::move(below);
  }
  std::vector<Index> faces;
  for (const std::size_t slot : nodes) faces.push_back(tree.mesh_face(slot));
  return faces;
}

}  // namespace meshalyzer
