#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/items_by_group.h"
#include "meshalyzer/defects/internal/places.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns the faces of all pairs, ascending.
std::vector<Index> faces_of(std::span<const IntersectingPair> pairs) {
  std::vector<Index> faces;
  faces.reserve(2 * pairs.size());
  for (const IntersectingPair& pair : pairs) {
    faces.push_back(pair.face_a);
    faces.push_back(pair.face_b);
  }
  sort_unique(faces);
  return faces;
}

std::size_t place_in(std::span<const Index> sorted, Index face) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), face) -
                                  sorted.begin());
}

/// Joins faces that intersect or have a vertex in common; each is given by its position in a list.
DisjointSets join(const Soup& soup, std::span<const Index> faces,
                  std::span<const IntersectingPair> pairs) {
  DisjointSets sets(faces.size());
  std::vector<Index> face_at(soup.n_vertices(), kNoIndex);
  for (Index i = 0; i < faces.size(); ++i) {
    for (const Index v : soup.triangles[faces[i]]) {
      if (face_at[v] == kNoIndex) face_at[v] = i;
      sets.unite(face_at[v], i);
    }
  }
  for (const IntersectingPair& pair : pairs) {
    sets.unite(static_cast<Index>(place_in(faces, pair.face_a)),
               static_cast<Index>(place_in(faces, pair.face_b)));
  }
  return sets;
}

}  // namespace

DefectList find_self_intersection_patches(const PreparedMesh& mesh) {
  const std::vector<IntersectingPair>& pairs = mesh.intersecting_pairs();
  if (pairs.empty()) return {};
  const std::vector<Index> faces = faces_of(pairs);
  const DisjointSets::Numbers patches = join(mesh.soup(), faces, pairs).number_all();
  std::vector<Index> patch_of_pair;
  patch_of_pair.reserve(pairs.size());
  for (const IntersectingPair& pair : pairs) {
    patch_of_pair.push_back(patches.of[place_in(faces, pair.face_a)]);
  }
  const ItemsByGroup faces_of_patch(patches.of, patches.count);
  const ItemsByGroup pairs_of_patch(patch_of_pair, patches.count);
  DefectList defects;
  for (std::size_t patch = 0; patch < patches.count; ++patch) {
    Defect defect = make_defect(DefectCode::SelfIntersection);
    for (const Index i : faces_of_patch[patch]) defect.faces.push_back(faces[i]);
    for (const Index i : pairs_of_patch[patch]) defect.pairs.push_back(pairs[i]);
    defect.positions = middle_of_face(mesh.soup(), defect.faces.front());
    defect.value = static_cast<double>(defect.pairs.size());
    defects.push_back(defect);
  }
  return defects;
}

}  // namespace meshalyzer
