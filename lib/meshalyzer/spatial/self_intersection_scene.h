#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/spatial/corner_angles.h"
#include "meshalyzer/spatial/face_groups.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/fan_tree.h"
#include "meshalyzer/spatial/shared_vertices.h"
#include "meshalyzer/spatial/slab_tree.h"

#include <cstdint>
#include <span>

namespace meshalyzer {

/// The input of a search for the intersecting pairs of one mesh. It only refers to its data.
struct SelfIntersectionScene {
  const CutMesh& cut;
  /// A tree over the faces of `cut`, at least one.
  const FaceTree& tree;
  const SlabTree& slabs;
  const FanTree& fans;
  /// #leaves: bit i is set if the partners of the face at slot 8 leaf + i are wanted. If empty,
  /// those of all faces are wanted.
  std::span<const std::uint8_t> wanted = {};
  /// Non-zero for each file vertex whose faces surely do not intersect (see prove_stars()); empty
  /// if nothing is known.
  std::span<const std::uint8_t> proven = {};
  /// Angles at crowded vertices; null if there are none.
  const CornerAngles* angles = nullptr;
  /// Which leaves have vertices in common; null if all of their vertices are to be compared.
  const SharedVertices* shared = nullptr;
  /// The groups of faces represented by others; null if all are searched. It excludes `wanted`.
  const FaceGroups* groups = nullptr;
};

}  // namespace meshalyzer
