#include "meshalyzer/repair/replace/internal/offset_parts.h"

#include "support/run_pass.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace meshalyzer {
namespace {

constexpr double kLeast = 0.01;
/// The step along the mean normal makes vertices miss the planes by some thousandths.
constexpr double kWithin = 0.003 * kLeast;

/// #vertices: how far each is moved; the pass is run once.
std::vector<Vec3> offsets_of(const Soup& soup) {
  bool has_run = false;
  const PassRun run = run_pass(soup, [&](const PassInput& input) {
    if (has_run) return PassResult{};
    has_run = true;
    return offset_parts(input, kLeast);
  });
  std::vector<Vec3> offsets;
  for (std::size_t v = 0; v < soup.n_vertices(); ++v) {
    offsets.emplace_back(run.tracked.soup.positions[v] - soup.positions[v]);
  }
  return offsets;
}

TEST(OffsetParts, MovesTheWallsOfACubeOutwardAlike) {
  const Soup cube = shapes::cube();
  const std::vector<Vec3> offsets =
      offsets_of(shapes::merged(cube, shapes::cube(1, {0.5, 0.5, 0.5})));
  const double distance = std::abs(offsets[0].x());
  EXPECT_GE(distance, kLeast - kWithin);
  EXPECT_LE(distance, 2 * kLeast);
  for (Index v = 0; v < cube.n_vertices(); ++v) {
    const Vec3 from_middle = 2 * (cube.positions[v] - Vec3(0.5, 0.5, 0.5));
    EXPECT_LT((offsets[v] - distance * from_middle).norm(), kWithin);
  }
}

TEST(OffsetParts, KeepsASheetFlat) {
  const std::vector<Vec3> offsets = offsets_of(shapes::grid(3, 3));
  for (const Vec3& offset : offsets) EXPECT_LT((offset - offsets[0]).norm(), kWithin);
  EXPECT_GE(std::abs(offsets[0].z()), kLeast - kWithin);
}

TEST(OffsetParts, MakesCavitiesSmaller) {
  const Soup cubes = shapes::nested_cubes(shapes::InnerShell::Cavity);
  const Soup bar = shapes::box({-1, 1.4, 1.4}, {4, 1.6, 1.6});
  const std::vector<Vec3> offsets = offsets_of(shapes::merged(cubes, bar));
  const Vec3 middle(1.5, 1.5, 1.5);
  for (Index v = 0; v < cubes.n_vertices(); ++v) {
    const Vec3 from_middle = cubes.positions[v] - middle;
    const bool is_outer = from_middle.norm() > 1.0;
    EXPECT_EQ(offsets[v].dot(from_middle) > 0, is_outer);
  }
}

TEST(OffsetParts, MovesEachPartByADistanceOfItsOwn) {
  const Soup cubes = shapes::merged(shapes::cube(), shapes::cube(1, {0, 0, 1}));
  const std::vector<Vec3> offsets = offsets_of(cubes);
  EXPECT_GT(std::abs(offsets.front().norm() - offsets.back().norm()), 0.1 * kLeast);
}

TEST(OffsetParts, MovesSharpTipsByTwiceTheDistanceAtMost) {
  const Soup needle = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 10}},
                                   {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  for (const Vec3& offset : offsets_of(needle)) {
    EXPECT_GE(offset.norm(), kLeast - kWithin);
    EXPECT_LE(offset.norm(), 4 * kLeast);
  }
}

TEST(OffsetParts, LeavesClosedPartsThatMeetNothing) {
  const Soup far = shapes::cube(1, {5, 0, 0});
  const std::vector<Vec3> offsets =
      offsets_of(shapes::merged(far, shapes::merged(shapes::cube(), shapes::cube(1, {1, 0, 0}))));
  for (Index v = 0; v < offsets.size(); ++v) {
    EXPECT_EQ(offsets[v] == Vec3(0, 0, 0), v < far.n_vertices());
  }
}

TEST(OffsetParts, LeavesVerticesWithoutAFaceThatHasANormal) {
  // A face without area, one that repeats a vertex, and a vertex without any.
  const Soup soup =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}}, {{0, 1, 2}, {0, 0, 1}});
  for (const Vec3& offset : offsets_of(soup)) EXPECT_EQ(offset, Vec3(0, 0, 0));
}

}  // namespace
}  // namespace meshalyzer
