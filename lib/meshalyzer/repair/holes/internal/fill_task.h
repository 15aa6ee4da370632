#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/holes/internal/existing_edges.h"
#include "meshalyzer/repair/passes.h"

namespace meshalyzer {

class FillMemory;
class TriangulationMemory;

/// The data that filling a loop needs.
struct FillTask {
  const PreparedMesh& mesh;
  const ExistingEdges& existing;
  /// Triangles with an altitude below this are avoided. In the mesh's unit.
  double degeneracy = 0.0;
  FillShape shape = FillShape::Auto;
  /// Called before each step of filling a loop; once it returns true, no patch is found any more.
  StopQuery wants_to_stop = {};
  /// If given, loops that are known to have no patch are not tried.
  FillMemory* memory = nullptr;
  /// If given, the triangulations of loops are remembered.
  TriangulationMemory* triangulations = nullptr;
};

}  // namespace meshalyzer
