#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

struct ChainOptions {
  /// Only chains of so many edges at most; 0: all.
  std::size_t max_edges = 0;
  /// If any: only the chain that is nearest to each of these, by its edges.
  std::vector<Vec3> near_positions = {};
};

/// A closed or open walk along border edges, one side of a mesh (a laminar chain).
struct BoundaryChain {
  /// File vertices in walking order, faces to the left; each edge runs from one to the next, and a
  /// closed chain's last one back to the first.
  std::vector<Index> vertices;
  bool is_closed = true;
};

/// Finds the chains of border edges: the boundaries of find_boundary_loops(), each cut into simple
/// loops where it passes a vertex twice.
///
/// @return  In order of their lowest border edge; with near_positions in their order, each once.
[[nodiscard]] std::vector<BoundaryChain> find_boundary_chains(const PreparedMesh& mesh,
                                                              const ChainOptions& options = {});

}  // namespace meshalyzer
