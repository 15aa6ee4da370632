#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/spatial/face_groups.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/fan_tree.h"
#include "meshalyzer/spatial/pair_limits.h"
#include "meshalyzer/spatial/pair_listener.h"
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
  /// Faces that others stand for; null where all are searched. Not with `wanted`.
  const FaceGroups* groups = nullptr;
};

/// Finds the pairs with at least one wanted face, each once, with its kind.
///
/// @return  By file face, ascending; the same for any number of threads.
[[nodiscard]] std::vector<IntersectingPair> search_self_intersections(
    const SelfIntersectionScene& scene);

/// Hands on the pairs that search_self_intersections() finds. Which pairs these are is the same for
/// any number of threads, unless the search was told to stop.
///
/// @param limits  Where max_found ends the search, it finds that many or a few more.
/// @return        Whether the search went to its end.
bool search_self_intersections(const SelfIntersectionScene& scene, const PairLimits& limits,
                               PairListener& listener);

}  // namespace meshalyzer
