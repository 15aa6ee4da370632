#include "meshalyzer/boolean/part_from.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/mutual_intersection.h"
#include "support/no_lengths.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

/// A mesh without another one, moved off it.
struct Parted {
  Parted(const Soup& mesh, const Soup& other)
      : meshes{mesh, other},
        all(concatenate(meshes)),
        solid(combine_solids(operands_of(all, meshes), difference_rule())),
        vertices(part_from(solid, operands_of(all, meshes), other, 1e-3)) {
    for (std::size_t i = 0; i < vertices.vertices.size(); ++i) {
      solid.positions[vertices.vertices[i]] = vertices.positions[i];
    }
  }

  [[nodiscard]] bool touches() const {
    const CutMesh a = build(as_soup(solid));
    const CutMesh b = build(meshes[1]);
    return do_intersect(FaceTree(a), FaceTree(b));
  }

  std::vector<Soup> meshes;
  Soup all;
  CombinedSolid solid;
  PartedVertices vertices;
};

TEST(PartFrom, CubeOnACubeIsLiftedByItsLowerFace) {
  const Parted parted(shapes::cube(1, {0.5, 0.5, 2}), shapes::cube(2));
  EXPECT_EQ(parted.vertices.vertices, (std::vector<Index>{0, 1, 2, 3}));
  for (const Vec3& p : parted.vertices.positions) EXPECT_GT(p.z(), 2.0);
  // Some units in the last place of the largest coordinate, which is 3.
  EXPECT_LT(parted.vertices.largest_move, 1e-12);
  EXPECT_EQ(parted.vertices.n_pairs_left, 0U);
  EXPECT_FALSE(parted.touches());
}

TEST(PartFrom, WallsThatMeetInAnEdgeMoveItOffBoth) {
  const Parted parted(shapes::cube(2), shapes::cube(2, {1, 1, -1}));
  EXPECT_EQ(parted.vertices.n_pairs_left, 0U);
  EXPECT_LT(parted.vertices.largest_move, 1e-12);
  EXPECT_FALSE(parted.touches());
}

TEST(PartFrom, CubesThatShareAnEdgeOnlyAreParted) {
  const Parted parted(shapes::cube(1, {1, 1, 0}), shapes::cube());
  EXPECT_EQ(parted.vertices.vertices.size(), 2U);
  EXPECT_FALSE(parted.touches());
}

TEST(PartFrom, WhatTouchesNothingStays) {
  const Parted parted(shapes::cube(), shapes::cube(1, {1.5, 0, 0}));
  EXPECT_TRUE(parted.vertices.vertices.empty());
  EXPECT_EQ(parted.vertices.largest_move, 0.0);
  EXPECT_EQ(parted.vertices.n_pairs_left, 0U);
}

TEST(PartFrom, WhatEntersTheOthersIsLeft) {
  const std::vector<Soup> alone{shapes::cube()};
  const Operands operands = operands_of(alone.front(), alone);
  const CombinedSolid solid = combine_solids(operands, difference_rule());
  const PartedVertices parted = part_from(solid, operands, shapes::cube(1, {0.5, 0.1, 0.2}), 1e-6);
  EXPECT_GT(parted.n_pairs_left, 0U);
  EXPECT_LE(parted.largest_move, 1.0001e-6);
}

TEST(PartFrom, DistanceThatIsNoLengthIsRefused) {
  const Parted parted(shapes::cube(), shapes::cube(1, {5, 0, 0}));
  for (const double no_length : test::kNoLengths) {
    EXPECT_THROW(static_cast<void>(part_from(parted.solid, operands_of(parted.all, parted.meshes),
                                             parted.meshes[1], no_length)),
                 InvalidArgument)
        << no_length;
  }
}

}  // namespace
}  // namespace meshalyzer
