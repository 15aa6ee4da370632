#include "meshalyzer/spatial/proven_stars.h"

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/pair_collector.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "meshalyzer/spatial/self_intersection_search.h"
#include "support/effort.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "support/sliver_tube.h"
#include "unit/spatial/pairs_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace meshalyzer {
namespace {

using Random = std::mt19937;
using Marks = std::vector<std::uint8_t>;

Marks proven_of(const Soup& soup) {
  return prove_stars(build(soup));
}

std::size_t n_proven(const Soup& soup) {
  const Marks marks = proven_of(soup);
  return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
}

TEST(ProveStars, ProvesAllOfGoodMeshes) {
  for (const Soup& soup : {shapes::cube(), shapes::open_cube(), shapes::uv_sphere(9, 14),
                           shapes::torus(2, 0.5, 30, 20)}) {
    EXPECT_EQ(n_proven(soup), soup.n_vertices());
  }
}

TEST(ProveStars, ProvesTheInsideOfAPlaneAndItsBorder) {
  EXPECT_EQ(n_proven(shapes::grid(20, 20)), 21u * 21u);
}

/// Two unit cubes, of which the second has those vertices of the first that are at the same places.
Soup two_cubes(const Vec3& corner) {
  Soup soup = shapes::merged(shapes::cube(), shapes::cube(1.0, corner));
  for (Triangle& t : soup.triangles) {
    for (Index& v : t) {
      const auto first = std::find(soup.positions.begin(), soup.positions.end(), soup.positions[v]);
      v = static_cast<Index>(first - soup.positions.begin());
    }
  }
  return soup;
}

/// The places of the first cube's vertices that are not proven.
std::vector<Vec3> unproven_of_first_cube(const Soup& cubes) {
  const Marks marks = proven_of(cubes);
  std::vector<Vec3> places;
  for (Index v = 0; v < 8; ++v) {
    if (marks[v] == 0) places.push_back(cubes.positions[v]);
  }
  std::sort(places.begin(), places.end(),
            [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  return places;
}

TEST(ProveStars, LeavesOutVerticesWithCopies) {
  EXPECT_EQ(unproven_of_first_cube(two_cubes({5, 0, 0})), std::vector<Vec3>{});
  EXPECT_EQ(unproven_of_first_cube(two_cubes({1, 1, 1})), (std::vector<Vec3>{{1, 1, 1}}));
}

TEST(ProveStars, LeavesOutTheEndsOfCutEdges) {
  EXPECT_EQ(unproven_of_first_cube(two_cubes({1, 1, 0})),
            (std::vector<Vec3>{{1, 1, 0}, {1, 1, 1}}));
  // One face of a grid turned over: the three edges round it are crossed twice in one direction.
  const Soup grid = shapes::grid(6, 6);
  const Index turned = 25;
  const Marks marks = proven_of(shapes::flipped(grid, std::array{turned}));
  for (Index v = 0; v < grid.n_vertices(); ++v) {
    const Triangle& t = grid.triangles[turned];
    EXPECT_EQ(marks[v], std::find(t.begin(), t.end(), v) == t.end() ? 1 : 0) << "vertex " << v;
  }
}

TEST(ProveStars, ProvesNothingOfAPillowNorOfAnOrphan) {
  EXPECT_EQ(n_proven(shapes::pillow()), 0u);
  EXPECT_EQ(proven_of(shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}}, {{0, 1, 2}})),
            (Marks{1, 1, 1, 0}));
}

/// Searches with and without the proven vertices must give the same pairs, and give their number.
std::size_t expect_same_pairs(const Soup& soup) {
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  const SlabTree slabs(tree);
  const FanTree fans(tree);
  PairCollector collector(kAllPairs);
  EXPECT_TRUE(search_self_intersections({.cut = cut, .tree = tree, .slabs = slabs, .fans = fans},
                                        PairLimits(), collector));
  const Pairs all = collector.take().listed;
  EXPECT_EQ(find_self_intersections(cut, tree), all);
  return all.size();
}

std::vector<Soup> shapes_to_try() {
  return {shapes::uv_sphere(17, 23),
          shapes::icosphere(3),
          shapes::torus(2, 0.5, 30, 20),
          shapes::genus_block(3),
          shapes::grid(20, 20),
          shapes::klein_bottle(20, 12),
          shapes::moebius_strip(40),
          shapes::projective_plane(),
          shapes::two_tetrahedra_sharing_face(),
          test::sliver_tube(60, {20, 22, 18})};
}

Soup moved(Soup soup, const std::function<double(double)>& move) {
  for (Vec3& p : soup.positions) {
    p = Vec3(move(p.x()), move(p.y()), move(p.z()));
  }
  return soup;
}

TEST(ProveStars, LeaveThePairsOfNoisyShapesAsTheyAre) {
  Random random(1);
  std::size_t n_pairs = 0;
  test::Effort effort;
  for (const double noise : {1e-15, 1e-9, 0.02, 0.1, 0.5}) {
    const auto shake = [&](double x) {
      return x + noise * (static_cast<double>(random()) / 0x1p31 - 1);
    };
    for (const Soup& soup : shapes_to_try()) {
      if (!effort.runs_next()) continue;
      n_pairs += expect_same_pairs(moved(soup, shake));
      n_pairs += expect_same_pairs(moved(damaged(soup, 9, random), shake));
    }
  }
  EXPECT_GT(n_pairs, 1000u);
}

TEST(ProveStars, LeaveThePairsOfGriddedShapesAsTheyAre) {
  Random random(2);
  std::size_t n_pairs = 0;
  test::Effort effort;
  for (const double step : {0.03125, 0.125, 0.1, 0.3, 1.0}) {
    const auto snap = [&](double x) { return step * std::round(x / step); };
    const auto snap_but_for_an_ulp = [&](double x) {
      return random() % 4 == 0 ? std::nextafter(snap(x), 9.0) : snap(x);
    };
    for (const Soup& soup : shapes_to_try()) {
      if (!effort.runs_next()) continue;
      n_pairs += expect_same_pairs(moved(soup, snap));
      n_pairs += expect_same_pairs(moved(damaged(soup, 9, random), snap_but_for_an_ulp));
    }
  }
  EXPECT_GT(n_pairs, 1000u);
}

}  // namespace
}  // namespace meshalyzer
