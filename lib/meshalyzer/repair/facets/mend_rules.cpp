#include "meshalyzer/repair/facets/mend_rules.h"

#include <algorithm>

namespace meshalyzer {

bool MendRules::is_between_groups(const WorkingMesh& mesh, Index vertex) const {
  const auto faces = mesh.star(vertex);
  if (input_.draft.soup.groups.empty() || faces.empty()) return false;
  const Index first = group(mesh, faces[0]);
  return std::any_of(faces.begin(), faces.end(), [&](Index f) { return group(mesh, f) != first; });
}

}  // namespace meshalyzer
