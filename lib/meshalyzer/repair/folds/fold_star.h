#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the repair module: what is taken out and put back where a foldover is removed.

/// All faces round some vertices: a disc.
struct FoldStar {
  /// Mesh faces, ascending.
  std::vector<Index> faces;
  /// Half-edges of these faces, counter-clockwise, each from where the one before ends.
  std::vector<HalfedgeHandle> outline;
};

/// Whether a file vertex is inside a surface that is manifold and consistently oriented there.
[[nodiscard]] bool is_inner(const CutMesh& cut, Index vertex);

/// @param vertices  File vertices inside the surface, see is_inner(), each once.
/// @return          Nothing where the faces are no disc that has just these vertices inside.
/// @complexity      O(n log n) for n faces.
[[nodiscard]] std::optional<FoldStar> star_of(const CutMesh& cut, std::span<const Index> vertices);

/// The line round some faces, if it is one that passes no vertex twice.
///
/// @param faces  Mesh faces, ascending.
/// @return       Half-edges of these faces, counter-clockwise, each from where the one before ends;
/// empty where the faces have several outlines, one that passes a vertex twice, or none.
[[nodiscard]] std::vector<HalfedgeHandle> outline_of(const TriMesh& mesh,
                                                     std::span<const Index> faces);

}  // namespace meshalyzer
