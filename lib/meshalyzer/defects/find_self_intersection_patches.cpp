#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
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

std::vector<Defect> find_self_intersection_patches(const PreparedMesh& mesh) {
  const std::vector<IntersectingPair>& pairs = mesh.intersecting_pairs();
  if (pairs.empty()) return {};
  const std::vector<Index> faces = faces_of(pairs);
  const std::vector<Index> patch = join(mesh.soup(), faces, pairs).number_all().of;
  std::vector<Defect> defects;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (patch[i] == defects.size()) {
      Defect& defect = defects.emplace_back(make_defect(DefectCode::SelfIntersection));
      defect.positions = middle_of_face(mesh.soup(), faces[i]);
    }
    defects[patch[i]].faces.push_back(faces[i]);
  }
  for (const IntersectingPair& pair : pairs) {
    defects[patch[place_in(faces, pair.face_a)]].pairs.push_back(pair);
  }
  for (Defect& defect : defects) defect.value = static_cast<double>(defect.pairs.size());
  return defects;
}

}  // namespace meshalyzer
