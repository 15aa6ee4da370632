#include "meshalyzer/repair/driver/internal/pairs_of_faces.h"

#include "meshalyzer/spatial/self_intersection_of.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

bool comes_before(const IntersectingPair& p, const IntersectingPair& q) {
  return std::pair(p.face_a, p.face_b) < std::pair(q.face_a, q.face_b);
}

}  // namespace

std::vector<IntersectingPair> find_pairs_of(const PreparedMesh& mesh,
                                            const std::vector<Index>& faces) {
  return is_worth_a_tree(faces.size(), mesh.soup().n_faces())
             ? find_self_intersections_of(mesh.cut(), mesh.tree(), faces)
             : find_self_intersections_of(mesh.cut(), mesh.soup(), faces).listed;
}

std::vector<IntersectingPair> joined_pairs(std::vector<IntersectingPair> of_faces,
                                           const std::vector<IntersectingPair>& others) {
  const auto n_of_faces = static_cast<std::ptrdiff_t>(of_faces.size());
  of_faces.insert(of_faces.end(), others.begin(), others.end());
  const auto middle = of_faces.begin() + n_of_faces;
  // Nearly always the order of faces has not changed.
  if (!std::is_sorted(of_faces.begin(), middle, comes_before)) {
    std::sort(of_faces.begin(), middle, comes_before);
  }
  if (!std::is_sorted(middle, of_faces.end(), comes_before)) {
    std::sort(middle, of_faces.end(), comes_before);
  }
  std::inplace_merge(of_faces.begin(), middle, of_faces.end(), comes_before);
  return of_faces;
}

}  // namespace meshalyzer
