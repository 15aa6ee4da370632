#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/rules/internal/drop_unmissed_faces.h"
#include "meshalyzer/repair/split/internal/walls_between_cells.h"

namespace meshalyzer {

PassResult drop_dividing_walls(const PassInput& input) {
  const WallsBetweenCells found = find_walls_between_cells(input.mesh, input.wants_to_stop);
  return drop_unmissed_faces(input, found.sets, DefectCode::NonManifold);
}

}  // namespace meshalyzer
