#include "meshalyzer/spatial/nesting.h"

#include "meshalyzer/geometry/volume.h"
#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

/// The nesting of meshes put into one file, all closed.
Nesting nested(const std::vector<Soup>& parts, const std::vector<PartContact>& contacts = {}) {
  Soup all;
  std::vector<Index> part_of_face;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    all = shapes::merged(std::move(all), parts[i]);
    part_of_face.insert(part_of_face.end(), parts[i].n_faces(), static_cast<Index>(i));
  }
  const CutMesh cut = build(all);
  const std::vector<std::uint8_t> closed(parts.size(), 1);
  const FaceParts face_parts{.of_face = part_of_face, .count = parts.size()};
  return find_nesting(FaceTree(cut), {.parts = face_parts,
                                      .boxes = bounding_boxes(cut.mesh, face_parts),
                                      .is_closed = closed,
                                      .contacts = contacts});
}

TEST(FindNesting, SeparateCubesAreNotNested) {
  const Nesting nesting = nested({shapes::cube(), shapes::cube(1, {2, 0, 0})});
  EXPECT_EQ(nesting.depth, (std::vector<Index>{0, 0}));
  EXPECT_EQ(nesting.inside, (std::vector<Index>{kNoIndex, kNoIndex}));
}

TEST(FindNesting, ShellsKnowTheInnermostAroundThem) {
  const Nesting nesting = nested({shapes::cube(1, {2, 2, 2}), shapes::cube(5),
                                  shapes::cube(3, {1, 1, 1}), shapes::cube(1, {9, 0, 0})});
  EXPECT_EQ(nesting.depth, (std::vector<Index>{2, 0, 1, 0}));
  EXPECT_EQ(nesting.inside, (std::vector<Index>{2, kNoIndex, 1, kNoIndex}));
}

TEST(FindNesting, BoxInsideTheBoxOfATorusButOutsideItsTubeIsOutside) {
  const Nesting nesting =
      nested({shapes::cube(0.2, {-0.1, -0.1, -0.1}), shapes::torus(2, 0.5, 20, 12)});
  EXPECT_EQ(nesting.depth, (std::vector<Index>{0, 0}));
}

TEST(FindNesting, PartsThatCrossDoNotEncloseEachOther) {
  const Nesting nesting = nested({shapes::cube(2), shapes::cube(2, {1, 1, 1})}, {{0, 1, true}});
  EXPECT_EQ(nesting.depth, (std::vector<Index>{0, 0}));
}

TEST(FindNesting, CubeThatTouchesTheWallFromWithinIsInside) {
  const Nesting nesting = nested({shapes::cube(3), shapes::cube(1, {0, 1, 1})}, {{0, 1, false}});
  EXPECT_EQ(nesting.inside, (std::vector<Index>{kNoIndex, 0}));
}

TEST(FindNesting, CubeThatTouchesTheWallFromWithoutIsOutside) {
  const Nesting nesting = nested({shapes::cube(3), shapes::cube(1, {3, 1, 1})}, {{0, 1, false}});
  EXPECT_EQ(nesting.depth, (std::vector<Index>{0, 0}));
}

TEST(FindNesting, BoxFromOneWallToAnotherIsInsideThoughAllItsVerticesLieOnWalls) {
  const Soup box = shapes::box({1, 1, 0}, {2, 2, 3});
  const Nesting nesting = nested({shapes::cube(3), box}, {{0, 1, false}});
  EXPECT_EQ(nesting.inside, (std::vector<Index>{kNoIndex, 0}));
}

TEST(FindNesting, BoxThatFillsAGapIsOutsideThoughAllItsVerticesLieOnWalls) {
  const Soup walls = shapes::merged(shapes::cube(), shapes::cube(1, {2, 0, 0}));
  const Nesting nesting = nested({walls, shapes::cube(1, {1, 0, 0})}, {{0, 1, false}});
  EXPECT_EQ(nesting.depth, (std::vector<Index>{0, 0}));
}

TEST(FindNesting, PartThatReachesOutIsNotInsideThoughItBeginsThere) {
  const Nesting nesting =
      nested({shapes::cube(3), shapes::cube(2, {2, 2, 2})}, {{0, 1, /*crosses=*/false}});
  EXPECT_EQ(nesting.depth, (std::vector<Index>{0, 0}));
}

TEST(FindNesting, OpenPartsEncloseNothing) {
  const Soup outer = shapes::cube(3);
  const Soup inner = shapes::cube(1, {1, 1, 1});
  const CutMesh cut = build(shapes::merged(outer, inner));
  std::vector<Index> part_of_face(24, 0);
  std::fill(part_of_face.begin() + 12, part_of_face.end(), Index{1});
  const std::vector<std::uint8_t> closed{0, 1};
  const FaceParts parts{.of_face = part_of_face, .count = 2};
  const Nesting nesting = find_nesting(FaceTree(cut), {.parts = parts,
                                                       .boxes = bounding_boxes(cut.mesh, parts),
                                                       .is_closed = closed,
                                                       .contacts = {}});
  EXPECT_EQ(nesting.depth, (std::vector<Index>{0, 0}));
}

}  // namespace
}  // namespace meshalyzer
