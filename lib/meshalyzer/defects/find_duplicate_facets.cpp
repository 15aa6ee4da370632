#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"
#include "meshalyzer/topology/duplicate_faces.h"

#include <algorithm>
#include <cstdint>

namespace meshalyzer {
namespace {

/// Returns the triangles that several faces name, each once, ascending.
std::vector<Triangle> find_repeated_triangles(const PreparedMesh& mesh) {
  std::vector<Triangle> repeated;
  for (const FaceHandle f : find_duplicate_faces(mesh.cut())) {
    repeated.push_back(sorted_corners(mesh.soup().triangles[mesh.cut().side.face(f)]));
  }
  sort_unique(repeated);
  return repeated;
}

struct Copy {
  /// The position of its triangle among the repeated ones.
  Index triangle;
  Index face;
};

/// Returns all faces that name a repeated triangle, the first of each included, ascending.
std::vector<Copy> find_copies(const Soup& soup, const std::vector<Triangle>& repeated) {
  // The lowest vertex already distinguishes most faces.
  std::vector<std::uint8_t> is_lowest(soup.n_vertices(), 0);
  for (const Triangle& t : repeated) is_lowest[t[0]] = 1;
  return collect_chunks<Copy>(soup.n_faces(), [&](Chunk chunk, std::vector<Copy>& copies) {
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      const Triangle t = sorted_corners(soup.triangles[f]);
      if (!is_in_complex(t) || is_lowest[t[0]] == 0) continue;
      const auto found = std::lower_bound(repeated.begin(), repeated.end(), t);
      if (found == repeated.end() || *found != t) continue;
      copies.push_back({static_cast<Index>(found - repeated.begin()), static_cast<Index>(f)});
    }
  });
}

}  // namespace

DefectList find_duplicate_facets(const PreparedMesh& mesh) {
  const std::vector<Triangle> repeated = find_repeated_triangles(mesh);
  if (repeated.empty()) return {};
  const std::vector<Copy> copies = find_copies(mesh.soup(), repeated);
  // Sets of equal faces are numbered in order of their first face.
  std::vector<Index> number(repeated.size(), kNoIndex);
  Index n_sets = 0;
  std::vector<Index> set_of;
  set_of.reserve(copies.size());
  for (const Copy& copy : copies) {
    if (number[copy.triangle] == kNoIndex) number[copy.triangle] = n_sets++;
    set_of.push_back(number[copy.triangle]);
  }
  const ItemsByGroup sets(set_of, n_sets);
  DefectList defects;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    Defect defect = make_defect(DefectCode::DuplicateFacet);
    for (const Index i : sets[s]) defect.faces.push_back(copies[i].face);
    defect.positions = middle_of_face(mesh.soup(), defect.faces.front());
    defect.value = static_cast<double>(defect.faces.size());
    defects.push_back(defect);
  }
  return defects;
}

}  // namespace meshalyzer
