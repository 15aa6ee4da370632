#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"
#include "meshalyzer/topology/duplicate_faces.h"

#include <algorithm>
#include <cstdint>

namespace meshalyzer {
namespace {

/// Returns the corners in ascending order, so that faces with the same vertices are equal.
Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Returns the triangles that several faces name, each once, ascending.
std::vector<Triangle> find_repeated_triangles(const PreparedMesh& mesh) {
  std::vector<Triangle> repeated;
  for (const FaceHandle f : find_duplicate_faces(mesh.cut())) {
    repeated.push_back(sorted(mesh.soup().triangles[mesh.cut().side.face(f)]));
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
  const auto parts = map_chunks<std::vector<Copy>>(soup.n_faces(), [&](Chunk chunk) {
    std::vector<Copy> copies;
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      const Triangle t = sorted(soup.triangles[f]);
      if (!is_in_complex(t) || is_lowest[t[0]] == 0) continue;
      const auto found = std::lower_bound(repeated.begin(), repeated.end(), t);
      if (found == repeated.end() || *found != t) continue;
      copies.push_back({static_cast<Index>(found - repeated.begin()), static_cast<Index>(f)});
    }
    return copies;
  });
  std::vector<Copy> copies;
  for (const auto& part : parts) copies.insert(copies.end(), part.begin(), part.end());
  return copies;
}

}  // namespace

std::vector<Defect> find_duplicate_facets(const PreparedMesh& mesh) {
  const std::vector<Triangle> repeated = find_repeated_triangles(mesh);
  if (repeated.empty()) return {};
  std::vector<Defect> defects;
  std::vector<Index> defect_of(repeated.size(), kNoIndex);
  for (const Copy& copy : find_copies(mesh.soup(), repeated)) {
    Index& number = defect_of[copy.triangle];
    if (number == kNoIndex) {
      number = static_cast<Index>(defects.size());
      defects.push_back(make_defect(DefectCode::DuplicateFacet));
      defects.back().positions = middle_of_face(mesh.soup(), copy.face);
    }
    defects[number].faces.push_back(copy.face);
  }
  for (Defect& defect : defects) defect.value = static_cast<double>(defect.faces.size());
  return defects;
}

}  // namespace meshalyzer
