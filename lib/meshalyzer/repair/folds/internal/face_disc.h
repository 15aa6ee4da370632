#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the repair module: the discs of faces that are exchanged to remove a foldover.

/// The faces round some vertices, which form a topological disc.
struct FaceDisc {
  /// Mesh faces, ascending.
  std::vector<Index> faces;
  /// Half-edges of these faces, counter-clockwise, each from the end of the one before.
  std::vector<HalfedgeHandle> outline;
};

/// Tells whether a file vertex is inside a surface that is manifold and consistently oriented
/// there.
[[nodiscard]] bool is_inner(const CutMesh& cut, Index vertex);

/// @param vertices  File vertices inside the surface, see is_inner(), each once.
/// @return          Nothing if the faces do not form a disc with exactly these vertices inside.
/// @complexity      O(n log n) for n faces.
[[nodiscard]] std::optional<FaceDisc> find_disc(const CutMesh& cut,
                                                std::span<const Index> vertices);

/// Returns the outline of some faces, if it is a single one that passes no vertex twice.
///
/// @param faces  Mesh faces, ascending.
/// @return       Half-edges of these faces, counter-clockwise, each from the end of the one before;
/// empty if the faces have several outlines, one that passes a vertex twice, or none.
[[nodiscard]] std::vector<HalfedgeHandle> outline_of(const TriMesh& mesh,
                                                     std::span<const Index> faces);

/// Returns the mesh faces that have a vertex of the outline of a disc but are not part of it, in
/// ascending order.
[[nodiscard]] std::vector<Index> faces_around(const CutMesh& cut, const FaceDisc& disc);

/// Tells whether one of some mesh faces has a border edge.
[[nodiscard]] bool reaches_border(const CutMesh& cut, std::span<const Index> faces);

/// Tells whether the border edges of an outline form a single run, and so do the others.
[[nodiscard]] bool has_one_crease(const CutMesh& cut, const std::vector<HalfedgeHandle>& outline);

}  // namespace meshalyzer
