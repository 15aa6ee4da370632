#include "meshalyzer/defects/finders.h"
#include "meshalyzer/repair/orient/side_votes.h"
#include "meshalyzer/repair/passes.h"

namespace meshalyzer {

PassResult orient_consistently(const PassInput& input) {
  PassResult result;
  // Of two patches on a flipped edge only one is to be turned: each patch may be, or not, on its
  // own.
  for (const Defect& patch : find_flipped(input.mesh)) {
    if (!patch.fixable) {
      result.refused.push_back({.code = patch.code,
                                .vertex = patch.edges.front()[0],
                                .face = patch.faces.front(),
                                .reason = "it has only one side: no turning makes it consistent"});
      continue;
    }
    const Index op = result.edits.begin_operation();
    for (const Index face : patch.faces) {
      result.edits.changed_faces.push_back(
          {op, face, turned_over(input.draft.soup.triangles[face])});
    }
  }
  return result;
}

}  // namespace meshalyzer
