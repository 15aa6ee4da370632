#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/edits/internal/turned_face.h"
#include "meshalyzer/repair/passes.h"

namespace meshalyzer {

PassResult orient_consistently(const PassInput& input) {
  PassResult result;
  // Only one of two regions on a flipped edge is to be turned, and each region may be turned by
  // itself.
  for (const Defect& region : find_flipped(input.mesh)) {
    if (!region.fixable) {
      result.refused.push_back({.code = region.code,
                                .vertex = region.edges.front()[0],
                                .face = region.faces.front(),
                                .reason = "it has only one side: no turning makes it consistent"});
      continue;
    }
    const Index op = result.edits.begin_operation();
    for (const Index face : region.faces) {
      result.edits.changed_faces.push_back(turned_face(input.tracked.soup, op, face));
    }
  }
  return result;
}

}  // namespace meshalyzer
