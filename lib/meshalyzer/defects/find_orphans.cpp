#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/mesh/repeated_ids.h"

#include <cstdint>

namespace meshalyzer {

DefectList find_orphans(const Soup& soup) {
  std::vector<std::uint8_t> is_known(soup.n_vertices(), 0);
  for (const Triangle& t : soup.triangles) {
    for (const Index v : t) {
      if (v != kNoIndex) is_known[v] = 1;
    }
  }
  for (const Index record : find_repeated_ids(soup.vertex_ids)) is_known[record] = 1;
  DefectList defects;
  for (Index v = 0; v < is_known.size(); ++v) {
    if (is_known[v] != 0) continue;
    Defect defect = make_defect(DefectCode::OrphanVertex);
    defect.vertices = {v};
    defect.positions = {soup.positions[v]};
    defects.push_back(defect);
  }
  return defects;
}

}  // namespace meshalyzer
