#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

/// The faces of some pairs, in a list, and where each stands in it.
struct ListedFaces {
  /// Ascending.
  std::vector<Index> faces;
  /// #faces of the mesh: its position in the list, or kNoIndex.
  std::vector<Index> place;
};

ListedFaces list_faces(std::span<const IntersectingPair> pairs, std::size_t n_faces) {
  ListedFaces listed{.faces = {}, .place = std::vector<Index>(n_faces, kNoIndex)};
  for (const IntersectingPair& pair : pairs) {
    listed.place[pair.face_a] = 0;
    listed.place[pair.face_b] = 0;
  }
  for (Index face = 0; face < n_faces; ++face) {
    if (listed.place[face] == kNoIndex) continue;
    listed.place[face] = static_cast<Index>(listed.faces.size());
    listed.faces.push_back(face);
  }
  return listed;
}

/// Joins faces that intersect or have a vertex in common; each is given by its position in the
/// list.
DisjointSets join(const Soup& soup, const ListedFaces& listed,
                  std::span<const IntersectingPair> pairs) {
  DisjointSets sets(listed.faces.size());
  std::vector<Index> face_at(soup.n_vertices(), kNoIndex);
  for (Index i = 0; i < listed.faces.size(); ++i) {
    for (const Index v : soup.triangles[listed.faces[i]]) {
      if (face_at[v] == kNoIndex) face_at[v] = i;
      sets.unite(face_at[v], i);
    }
  }
  for (const IntersectingPair& pair : pairs) {
    sets.unite(listed.place[pair.face_a], listed.place[pair.face_b]);
  }
  return sets;
}

}  // namespace

DefectList find_self_intersection_patches(const PreparedMesh& mesh) {
  const std::vector<IntersectingPair>& pairs = mesh.intersecting_pairs();
  if (pairs.empty()) return {};
  const ListedFaces listed = list_faces(pairs, mesh.soup().n_faces());
  const DisjointSets::Numbers patches = join(mesh.soup(), listed, pairs).number_all();
  std::vector<Index> patch_of_pair;
  patch_of_pair.reserve(pairs.size());
  for (const IntersectingPair& pair : pairs) {
    patch_of_pair.push_back(patches.of[listed.place[pair.face_a]]);
  }
  const ItemsByGroup faces_of_patch(patches.of, patches.count);
  const ItemsByGroup pairs_of_patch(patch_of_pair, patches.count);
  DefectList defects;
  for (std::size_t patch = 0; patch < patches.count; ++patch) {
    Defect defect = make_defect(DefectCode::SelfIntersection);
    for (const Index i : faces_of_patch[patch]) defect.faces.push_back(listed.faces[i]);
    for (const Index i : pairs_of_patch[patch]) defect.pairs.push_back(pairs[i]);
    defect.positions = middle_of_face(mesh.soup(), defect.faces.front());
    defect.value = static_cast<double>(defect.pairs.size());
    defects.push_back(defect);
  }
  return defects;
}

}  // namespace meshalyzer
