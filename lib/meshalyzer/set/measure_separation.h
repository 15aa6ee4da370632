#pragma once

#include "meshalyzer/set/object_cache.h"
#include "meshalyzer/set/separation.h"
#include "meshalyzer/spatial/box_tree.h"

#include <span>

namespace meshalyzer {

/// The objects of a set, by number. It only refers to its data.
struct SetScene {
  /// The box of the vertices that faces use, for each object; empty for excluded objects.
  std::span<const Box3> boxes;
  /// A tree over these boxes.
  const BoxTree& tree;
  /// A cache of objects that are prepared for ClosestUse::Prepared.
  ObjectCache& objects;
};

/// Measures the distance from each vertex of an object to the closest point of any other one.
///
/// The distance is the smallest of closest_on_triangle() over all faces, the same as without search
/// structures. Whether a vertex is inside is decided exactly.
///
/// @throws InvalidArgument  if a length of the options is negative or not finite, or the angle of
/// the cone outside 0 ... 90.
/// @complexity O(log objects + vertices x objects closer than their closest point x log faces); no
/// more than two objects are held at a time.
[[nodiscard]] ObjectSeparation measure_separation(Index object, const SetScene& scene,
                                                  const SeparationOptions& options);

}  // namespace meshalyzer
