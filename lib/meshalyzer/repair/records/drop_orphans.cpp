#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/passes.h"

#include <vector>

namespace meshalyzer {

PassResult drop_orphans(const PassInput& input) {
  PassResult result;
  const DefectList orphans = find_orphans(input.tracked.soup);
  if (input.tracked.soup.triangles.empty() && !orphans.empty()) {
    result.refused.push_back({DefectCode::OrphanVertex, orphans.front().vertices.front(), kNoIndex,
                              "there is no face: without them the file would hold nothing"});
    return result;
  }
  for (const Defect& defect : orphans) {
    const Index v = defect.vertices.front();
    if (input.limits.is_fixed(input.tracked, v)) {
      result.refused.push_back({defect.code, v, kNoIndex, "it has to stay"});
      continue;
    }
    // All are in one operation, because none can be rejected.
    if (result.edits.empty()) static_cast<void>(result.edits.begin_operation());
    result.edits.removed_vertices.push_back({0, v});
  }
  return result;
}

}  // namespace meshalyzer
