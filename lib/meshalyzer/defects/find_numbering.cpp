#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"
#include "meshalyzer/mesh/numbering.h"

#include <cstddef>

namespace meshalyzer {
namespace {

Defect wrong_number(const Ids& ids, Index record) {
  Defect defect = make_defect(DefectCode::Numbering);
  defect.value = static_cast<double>(ids.of(record));
  defect.limit = static_cast<double>(record) + 1;
  return defect;
}

}  // namespace

DefectList find_numbering(const Soup& soup) {
  DefectList defects;
  if (const auto vertex = first_misnumbered(soup.vertex_ids, soup.format, soup.n_vertices())) {
    Defect defect = wrong_number(soup.vertex_ids, *vertex);
    defect.vertices = {*vertex};
    defect.positions = {soup.positions[*vertex]};
    defects.push_back(defect);
  }
  if (const auto face = first_misnumbered(soup.face_ids, soup.format, soup.n_faces())) {
    Defect defect = wrong_number(soup.face_ids, *face);
    defect.faces = {*face};
    defect.positions = middle_of_face(soup, *face);
    defects.push_back(defect);
  }
  return defects;
}

}  // namespace meshalyzer
