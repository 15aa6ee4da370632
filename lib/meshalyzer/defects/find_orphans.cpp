#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/mesh/orphans.h"
#include "meshalyzer/mesh/repeated_ids.h"

namespace meshalyzer {

DefectList find_orphans(const Soup& soup) {
  DefectList defects;
  for (const Index v : find_orphan_vertices(soup, find_repeated_ids(soup.vertex_ids))) {
    Defect defect = make_defect(DefectCode::OrphanVertex);
    defect.vertices = {v};
    defect.positions = {soup.positions[v]};
    defects.push_back(defect);
  }
  return defects;
}

}  // namespace meshalyzer
