#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"

#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

/// Returns the first of `n` records whose id is not its number, counted from 1, or n if there is
/// none.
Index first_out_of_order(const Ids& ids, std::size_t n) {
  Index i = 0;
  while (i < n && ids.of(i) == std::int64_t{i} + 1) ++i;
  return i;
}

Defect wrong_number(const Ids& ids, Index record) {
  Defect defect = make_defect(DefectCode::Numbering);
  defect.value = static_cast<double>(ids.of(record));
  defect.limit = static_cast<double>(record) + 1;
  return defect;
}

}  // namespace

DefectList find_numbering(const Soup& soup) {
  DefectList defects;
  if (soup.format != Format::Mesh) return defects;
  const Index vertex = first_out_of_order(soup.vertex_ids, soup.n_vertices());
  if (vertex != soup.n_vertices()) {
    Defect defect = wrong_number(soup.vertex_ids, vertex);
    defect.vertices = {vertex};
    defect.positions = {soup.positions[vertex]};
    defects.push_back(defect);
  }
  const Index face = first_out_of_order(soup.face_ids, soup.n_faces());
  if (face != soup.n_faces()) {
    Defect defect = wrong_number(soup.face_ids, face);
    defect.faces = {face};
    defect.positions = middle_of_face(soup, face);
    defects.push_back(defect);
  }
  return defects;
}

}  // namespace meshalyzer
