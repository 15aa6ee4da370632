#pragma once

#include "meshalyzer/base/types.h"

#include <array>
#include <span>

namespace meshalyzer {

/// A face and twice the centre of its box.
struct FaceMiddle {
  std::array<float, 3> middle;
  Index face;
};

/// Sorts faces so that every aligned run of 8, 16, 32, ... is one side of a split at a median.
///
/// A split is along the widest axis. But where many faces are long and thin, runs of a few hundred
/// are split by their normals until these are much alike: what bounds a long body is then sorted
/// by its sides, each of which a slab tells apart from most other faces (see SlabTree), while boxes
/// tell hardly any of them apart, in whatever order they are.
///
/// @param triangles  By face.
/// @complexity       O(n log n).
void order_for_tree(std::span<FaceMiddle> faces, std::span<const Triangle> triangles,
                    std::span<const Vec3> points);

}  // namespace meshalyzer
