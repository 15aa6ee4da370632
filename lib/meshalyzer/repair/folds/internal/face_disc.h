#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the repair module: what is taken out and put back where a foldover is removed.

/// All faces round some vertices, which form a topological disc.
struct FaceDisc {
  /// Mesh faces, ascending.
  std::vector<Index> faces;
  /// Half-edges of these faces, counter-clockwise, each from where the one before ends.
  std::vector<HalfedgeHandle> outline;
};

/// Tells whether a file vertex is inside a surface that is manifold and consistently oriented
/// there.
[[nodiscard]] bool is_inner(const CutMesh& cut, Index vertex);

/// @param vertices  File vertices inside the surface, see is_inner(), each once.
/// @return          An empty optional where the faces do not form a disc with just these vertices
/// inside.
/// @complexity      O(n log n) for n faces.
[[nodiscard]] std::optional<FaceDisc> find_disc(const CutMesh& cut,
                                                std::span<const Index> vertices);

/// Returns the line round some faces, if it is one that passes no vertex twice.
///
/// @param faces  Mesh faces, ascending.
/// @return       Half-edges of these faces, counter-clockwise, each from where the one before ends;
/// empty where the faces have several outlines, one that passes a vertex twice, or none.
[[nodiscard]] std::vector<HalfedgeHandle> outline_of(const TriMesh& mesh,
                                                     std::span<const Index> faces);

/// Returns the mesh faces that have a vertex of the outline of a disc, but are not part of it;
/// ascending.
[[nodiscard]] std::vector<Index> faces_around(const CutMesh& cut, const FaceDisc& disc);

/// Tells whether one of some mesh faces has a border edge.
[[nodiscard]] bool reaches_border(const CutMesh& cut, std::span<const Index> faces);

/// Tells whether the border edges of an outline are one run of it, and the others another.
[[nodiscard]] bool has_one_crease(const CutMesh& cut, const std::vector<HalfedgeHandle>& outline);

}  // namespace meshalyzer
