#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// Selects the chains that find_boundary_chains() returns.
struct ChainOptions {
  /// Chains of more edges than this are left out; 0 leaves out none.
  std::size_t max_edges = 0;
  /// Positions that select chains: where there are any, only the chain whose edges are nearest to
  /// each of them is returned. They are finite.
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
/// @return  The chains in order of their lowest border edge; where ChainOptions::near_positions is
///          not empty in the order of those, each chain once.
/// @throws InvalidArgument  if such a position is not finite.
[[nodiscard]] std::vector<BoundaryChain> find_boundary_chains(const PreparedMesh& mesh,
                                                              const ChainOptions& options = {});

}  // namespace meshalyzer
