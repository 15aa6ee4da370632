#include "meshalyzer/defects/finders.h"
#include "meshalyzer/geometry/vertex_normals.h"
#include "meshalyzer/repair/passes.h"

#include <vector>

namespace meshalyzer {

PassResult renew_normals(const PassInput& input) {
  PassResult result;
  const DefectList opposed = find_opposed_normals(input.mesh);
  if (opposed.empty()) return result;
  const std::vector<Vec3> normals = vertex_normals(input.mesh.cut());
  for (const Defect& defect : opposed) {
    const Index vertex = defect.vertices.front();
    if (normals[vertex].isZero(0.0)) {
      result.refused.push_back({.code = defect.code,
                                .vertex = vertex,
                                .reason = "the normals of its faces cancel each other"});
      continue;
    }
    const Index op = result.edits.begin_operation();
    result.edits.changed_normals.push_back({op, vertex, normals[vertex]});
  }
  return result;
}

}  // namespace meshalyzer
