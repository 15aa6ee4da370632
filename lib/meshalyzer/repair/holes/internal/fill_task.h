#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/holes/internal/existing_edges.h"
#include "meshalyzer/repair/passes.h"

#include <functional>

namespace meshalyzer {

/// The data that filling a loop needs.
struct FillTask {
  const PreparedMesh& mesh;
  const ExistingEdges& existing;
  /// Triangles with an altitude below this are avoided. In the mesh's unit.
  double degeneracy = 0.0;
  FillShape shape = FillShape::Auto;
  /// Called before each step of filling a loop; once it returns true, no patch is found any more.
  /// May be empty.
  std::function<bool()> wants_to_stop = {};

  [[nodiscard]] bool is_to_stop() const { return wants_to_stop && wants_to_stop(); }
};

}  // namespace meshalyzer
