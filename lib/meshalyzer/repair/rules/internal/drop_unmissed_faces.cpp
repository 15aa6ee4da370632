#include "meshalyzer/repair/rules/internal/drop_unmissed_faces.h"

#include <algorithm>

namespace meshalyzer {

PassResult drop_unmissed_faces(const PassInput& input, std::span<const std::vector<Index>> sets,
                               DefectCode code) {
  PassResult result;
  for (const std::vector<Index>& faces : sets) {
    const bool is_held = std::any_of(faces.begin(), faces.end(), [&](Index face) {
      return input.limits.has_fixed_corner(input.tracked, face);
    });
    if (is_held) {
      result.refused.push_back({.code = code,
                                .face = faces.front(),
                                .reason = "it meets a vertex that must stay as it is"});
      continue;
    }
    const Index op = result.edits.begin_operation();
    for (const Index face : faces) {
      result.edits.removed_faces.push_back({op, face});
      result.edits.interior_walls.push_back({op, {corners_of(input.mesh.soup(), face), face}});
    }
  }
  return result;
}

}  // namespace meshalyzer
