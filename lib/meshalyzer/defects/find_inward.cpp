#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"

#include <cstddef>
#include <vector>

namespace meshalyzer {
namespace {

Defect inward_component(const Soup& soup, Index first_face, const Shell& shell) {
  Defect defect = make_defect(DefectCode::Inward);
  defect.faces = {first_face};
  defect.positions = middle_of_face(soup, first_face);
  defect.value = shell.volume;
  return defect;
}

}  // namespace

DefectList find_inward(const PreparedMesh& mesh) {
  const Components& components = mesh.components();
  DefectList defects;
  std::size_t n_seen = 0;
  for (std::size_t f = 0; f < components.of_face.size() && n_seen < components.count; ++f) {
    // Components are numbered in order of their lowest face.
    if (components.of_face[f] != n_seen) {
      continue;
    }
    const Shell& shell = mesh.shells()[n_seen++];
    if (!shell.outward.value_or(true)) {
      defects.push_back(inward_component(mesh.soup(), mesh.cut().side.faces[f], shell));
    }
  }
  return defects;
}

}  // namespace meshalyzer
