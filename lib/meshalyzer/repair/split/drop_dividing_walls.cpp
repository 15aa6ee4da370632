#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/split/internal/walls_between_cells.h"

#include <algorithm>
#include <vector>

namespace meshalyzer {

PassResult drop_dividing_walls(const PassInput& input) {
  PassResult result;
  const WallsBetweenCells found = find_walls_between_cells(input.mesh, input.wants_to_stop);
  for (const std::vector<Index>& walls : found.sets) {
    const bool is_held = std::any_of(walls.begin(), walls.end(), [&](Index face) {
      return input.limits.has_fixed_corner(input.tracked, face);
    });
    if (is_held) {
      result.refused.push_back({.code = DefectCode::NonManifold,
                                .face = walls.front(),
                                .reason = "it meets a vertex that must stay as it is"});
      continue;
    }
    const Index op = result.edits.begin_operation();
    for (const Index face : walls) {
      result.edits.removed_faces.push_back({op, face});
      result.edits.interior_walls.push_back({op, {corners_of(input.mesh.soup(), face), face}});
    }
  }
  return result;
}

}  // namespace meshalyzer
