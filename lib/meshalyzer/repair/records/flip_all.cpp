#include "meshalyzer/repair/passes.h"

namespace meshalyzer {

PassResult flip_all(const PassInput& input) {
  const Soup& soup = input.tracked.soup;
  PassResult result;
  if (soup.triangles.empty()) return result;
  const Index op = result.edits.begin_operation();
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    // Another list of the soup tells which corner is missing.
    if (!has_all_corners(t)) continue;
    result.edits.changed_faces.push_back(
        {.op = op, .face = f, .corners = {t[0], t[2], t[1]}, .turns_normals = true});
  }
  return result;
}

}  // namespace meshalyzer
