#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/fan_tree.h"
#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "meshalyzer/spatial/slab_tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The data that a search for the intersecting pairs of one mesh looks at. It only refers to them.
struct SelfIntersectionScene {
  const CutMesh& cut;
  /// A tree over the faces of `cut`, at least one.
  const FaceTree& tree;
  const SlabTree& slabs;
  const FanTree& fans;
  /// #leaves: bit i is set where the partners of the face at slot 8 leaf + i are wanted; empty:
  /// those of all faces are.
  std::span<const std::uint8_t> wanted = {};
  /// Non-zero for each file vertex whose faces surely share no more than they must (see
  /// prove_stars()); empty where nothing is known.
  std::span<const std::uint8_t> proven = {};
  /// The search ends when it has found so many.
  std::size_t max_pairs = kAllPairs;
};

/// Finds the pairs with at least one wanted face, each once, with its kind.
///
/// @return  By file face, ascending, never more than max_pairs; the same for any number of threads.
[[nodiscard]] std::vector<IntersectingPair> search_self_intersections(
    const SelfIntersectionScene& scene);

}  // namespace meshalyzer
