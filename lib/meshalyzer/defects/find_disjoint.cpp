#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

struct Part {
  /// The lowest record of its faces.
  Index face = kNoIndex;
  std::size_t n_faces = 0;
};

std::vector<Part> find_parts(const PreparedMesh& mesh) {
  const Components& components = mesh.components();
  std::vector<Part> parts(components.count);
  if (components.count < 2) return parts;
  for (std::size_t f = 0; f < components.of_face.size(); ++f) {
    Part& part = parts[components.of_face[f]];
    if (part.n_faces++ == 0) part.face = mesh.cut().side.faces[f];
  }
  return parts;
}

}  // namespace

DefectList find_disjoint(const PreparedMesh& mesh) {
  const std::vector<Part> parts = find_parts(mesh);
  const auto largest =
      std::max_element(parts.begin(), parts.end(),
                       [](const Part& a, const Part& b) { return a.n_faces < b.n_faces; });
  DefectList defects;
  for (auto part = parts.begin(); part != parts.end(); ++part) {
    if (part == largest) continue;
    Defect defect = make_defect(DefectCode::Disjoint);
    defect.faces = {part->face};
    defect.positions = middle_of_face(mesh.soup(), part->face);
    defect.value = static_cast<double>(part->n_faces);
    defects.push_back(defect);
  }
  return defects;
}

}  // namespace meshalyzer
