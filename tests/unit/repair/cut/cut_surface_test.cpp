#include "meshalyzer/repair/cut/internal/cut_surface.h"

#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/base/triangle.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// A ball of which one vertex has been pushed through and out on the other side: what of the spike
/// is outside is gone round the wrong way.
Soup pierced_ball() {
  Soup soup = shapes::icosphere(2);
  const auto top = std::max_element(soup.positions.begin(), soup.positions.end(),
                                    [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  *top *= -1.6;
  return soup;
}

CutSurface cut(const Soup& soup, Pockets pockets) {
  const TrackedMesh tracked = track_mesh(soup);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances;
  const RepairLimits limits{.max_deviation = 1.0, .fixed_vertices = {}};
  return cut_surface({soup, tracked, mesh, tolerances, limits}, {}, {.pockets = pockets},
                     {ThinFacets::Kept});
}

double area_of(const Corners& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2.0;
}

double area_of(const Soup& soup) {
  double area = 0.0;
  for (Index face = 0; face < soup.n_faces(); ++face) area += area_of(corners_of(soup, face));
  return area;
}

struct Areas {
  double kept = 0.0;
  double walls = 0.0;
};

Areas areas_of(const CutSurface& surface) {
  Soup kept;
  kept.positions = surface.positions;
  kept.triangles = surface.triangles;
  Areas areas{.kept = area_of(kept)};
  for (const InteriorWall& wall : surface.walls) areas.walls += area_of(wall.corners);
  return areas;
}

TEST(CutSurface, PocketsThatAreDroppedAreMissedUnlessForgotten) {
  const Soup soup = pierced_ball();
  const double area = area_of(soup);
  const CutSurface dropped = cut(soup, Pockets::Dropped);
  const CutSurface forgotten = cut(soup, Pockets::Forgotten);
  EXPECT_TRUE(dropped.unfinished.empty());
  EXPECT_EQ(forgotten.triangles, dropped.triangles);
  const double pocket = area - areas_of(dropped).kept - areas_of(dropped).walls;
  EXPECT_GT(pocket, 0.005 * area);
  EXPECT_NEAR(dropped.pocket_share * areas_of(dropped).kept, pocket, 1e-9 * area);
  EXPECT_NEAR(areas_of(forgotten).kept + areas_of(forgotten).walls, area, 1e-9 * area);
}

TEST(CutSurface, PocketsThatAreKeptLeaveNothingToMiss) {
  const Soup soup = pierced_ball();
  const Areas areas = areas_of(cut(soup, Pockets::Kept));
  EXPECT_NEAR(areas.kept + areas.walls, area_of(soup), 1e-9 * area_of(soup));
}

/// A ball with pockets beside it: balls inside out, whose vertices are some roundings apart. So
/// many planes nearly coincide that rounding makes faces intersect again and again.
Soup ball_and_pockets(std::size_t n_pockets) {
  const double rounding = std::ldexp(1.0, -51);
  Soup soup = shapes::icosphere(2);
  const Soup pocket = shapes::translated(shapes::scaled(shapes::flipped(shapes::icosphere(1)), 0.1),
                                         {3.0, 0.1, 0.7});
  std::minstd_rand random;
  for (std::size_t i = 0; i < n_pockets; ++i) {
    Soup next = pocket;
    for (Vec3& p : next.positions) {
      for (double& x : p) x += rounding * (static_cast<double>(random() % 3) - 1.0);
    }
    soup = shapes::merged(soup, next);
  }
  return soup;
}

TEST(CutSurface, PocketsAreForgottenIfTheyCannotBeCutToTheEnd) {
  const Soup soup = ball_and_pockets(6);
  const TrackedMesh tracked = track_mesh(soup);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances;
  const RepairLimits limits{.max_deviation = 1e-6, .fixed_vertices = {}};
  const PassInput input{soup, tracked, mesh, tolerances, limits};
  const auto cut = [&](Pockets pockets) {
    return cut_surface(input, {}, {.pockets = pockets}, {ThinFacets::Kept});
  };
  EXPECT_FALSE(cut(Pockets::Kept).unfinished.empty());
  const CutSurface forgotten = cut(Pockets::Forgotten);
  EXPECT_TRUE(forgotten.unfinished.empty());
  const CutSurface surface = cut_keeping_pockets(input, {}, Sheets::Left, 100'000);
  EXPECT_EQ(surface.triangles, forgotten.triangles);
  EXPECT_EQ(surface.positions, forgotten.positions);
}

double least_altitude(const CutSurface& surface) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : surface.triangles) {
    const Corners t{surface.positions[a], surface.positions[b], surface.positions[c]};
    least = std::min(least, 2.0 * area_of(t) / longest_side(t));
  }
  return least;
}

TEST(CutSurface, ThinFacetsThatCuttingMakesAreRemovedWhereTheyAreAskedFor) {
  // The bottoms of two cubes that cross are 1e-10 apart.
  const Soup soup = shapes::merged(shapes::cube(1), shapes::cube(0.7, {0.5, 0.2, 1e-10}));
  const TrackedMesh tracked = track_mesh(soup);
  const PreparedMesh mesh(tracked.soup);
  Tolerances tolerances;
  tolerances.degeneracy = 1e-8;
  const auto cut = [&](double max_deviation, ThinFacets thin_facets) {
    const RepairLimits limits{.max_deviation = max_deviation, .fixed_vertices = {}};
    return cut_surface({soup, tracked, mesh, tolerances, limits}, {}, {}, {thin_facets});
  };
  EXPECT_LT(least_altitude(cut(1e-3, ThinFacets::Kept)), 1e-9);
  EXPECT_FALSE(cut(1e-3, ThinFacets::Kept).has_removed_facets);
  // The tolerance must be small against the maximum deviation.
  EXPECT_FALSE(cut(1e-7, ThinFacets::Removed).has_removed_facets);
  const CutSurface surface = cut(1e-3, ThinFacets::Removed);
  EXPECT_TRUE(surface.has_removed_facets);
  EXPECT_TRUE(surface.unfinished.empty());
  EXPECT_GT(least_altitude(surface), 1e-8);
  const Soup solid = shapes::make(surface.positions, surface.triangles);
  EXPECT_TRUE(PreparedMesh(solid).intersecting_pairs().empty());
  // Inside the other are a square of 0.49 of the larger cube, and of the smaller one such a square
  // and four rectangles of 0.5 x 0.7.
  EXPECT_NEAR(area_of(solid), 6.0 + 6.0 * 0.49 - 0.49 - (4.0 * 0.35 + 0.49), 1e-6);
}

TEST(CutSurface, PartsThatAreLeftAreNotCutOn) {
  // A face crosses another 1e-10 beside an edge. Nothing tells which part of a sheet to drop, so
  // that both stay as they are, and removing their thin pieces would be in vain.
  const Soup soup = shapes::make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 1e-10, -1}, {0.8, 1e-10, -1}, {0.5, 1e-10, 1}},
      {{0, 1, 2}, {3, 4, 5}});
  const TrackedMesh tracked = track_mesh(soup);
  const PreparedMesh mesh(tracked.soup);
  Tolerances tolerances;
  tolerances.degeneracy = 1e-8;
  const RepairLimits limits{.max_deviation = 1e-3, .fixed_vertices = {}};
  const CutSurface surface =
      cut_surface({soup, tracked, mesh, tolerances, limits}, {}, {}, {ThinFacets::Removed});
  EXPECT_EQ(std::set<Index>(surface.of_uncut_sheets.begin(), surface.of_uncut_sheets.end()),
            (std::set<Index>{0, 1}));
  EXPECT_LT(least_altitude(surface), 1e-9);
  EXPECT_FALSE(surface.has_removed_facets);
}

bool has_too_many_pieces(const Soup& soup, std::size_t more_pieces) {
  const TrackedMesh tracked = track_mesh(soup);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances;
  const RepairLimits limits{.max_deviation = 1.0, .fixed_vertices = {}};
  return cut_surface({soup, tracked, mesh, tolerances, limits}, {}, {.sheets = Sheets::Cut},
                     {.more_pieces = more_pieces})
      .has_too_many_pieces;
}

TEST(CutSurface, NoMorePiecesAreMadeThanPermitted) {
  // Each of 40 upright triangles crosses 40 others, and is cut into more than 40 pieces.
  Soup soup;
  for (Index i = 0; i < 40; ++i) {
    const double at = 1.0 + i;
    for (const auto& [across, along] : {std::pair{0, 1}, std::pair{1, 0}}) {
      for (const double end : {-100.0, 200.0}) {
        Vec3 p = Vec3::Zero();
        p[across] = at;
        p[along] = end;
        soup.positions.push_back(p);
      }
      Vec3 top(0.0, 0.0, 100.0 + i);
      top[across] = at;
      soup.positions.push_back(top);
      const auto n = static_cast<Index>(soup.n_vertices());
      soup.triangles.push_back({n - 3, n - 2, n - 1});
    }
  }
  EXPECT_TRUE(has_too_many_pieces(soup, 0));
  EXPECT_FALSE(has_too_many_pieces(soup, 100'000));
}

/// Twenty copies of a mesh that overlap.
Soup overlapping_copies(const Soup& mesh) {
  Soup soup;
  for (int i = 0; i < 20; ++i) {
    soup = shapes::merged(std::move(soup), shapes::translated(mesh, {0.06 * i, 0.04 * (i % 3), 0}));
  }
  return soup;
}

TEST(CutSurface, PiecesInsideMayBeTwiceAsManyAsThoseThatStay) {
  const Soup ball = shapes::icosphere(2);
  const Soup solids = overlapping_copies(ball);
  const std::size_t n_pieces = arrange(solids).pieces.size();
  ASSERT_GT(n_pieces, 10 * solids.n_faces());
  ASSERT_LT(n_pieces, 20 * solids.n_faces());
  EXPECT_FALSE(has_too_many_pieces(solids, 0));
  // All pieces of hemispheres stay.
  std::vector<Index> upper;
  for (Index face = 0; face < ball.n_faces(); ++face) {
    if (centroid_of(corners_of(ball, face)).z() > 0.0) upper.push_back(face);
  }
  const Soup sheets = overlapping_copies(shapes::without_faces(ball, upper));
  const std::size_t n_of_sheets = arrange(sheets).pieces.size();
  ASSERT_GT(n_of_sheets, 10 * sheets.n_faces());
  ASSERT_LT(n_of_sheets, 20 * sheets.n_faces());
  EXPECT_TRUE(has_too_many_pieces(sheets, 0));
}

TEST(CutSurface, IsGivenUpWhereMovingVerticesHasMultipliedThePairs) {
  const Soup ball = shapes::icosphere(3);
  const Soup apart = shapes::merged(ball, shapes::translated(ball, {5, 0, 0}));
  const Soup crossing = shapes::merged(ball, shapes::translated(ball, {1, 0, 0}));
  const TrackedMesh tracked = track_mesh(apart);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances;
  const RepairLimits limits{.max_deviation = 1.0, .fixed_vertices = {}};
  const auto cut_moved = [&](std::size_t n_pairs_in_place) {
    return cut_surface(
        {apart, tracked, mesh, tolerances, limits},
        {.patches = {}, .positions = crossing.positions, .n_pairs_in_place = n_pairs_in_place}, {},
        {});
  };
  const CutSurface whole = cut_moved(0);
  EXPECT_TRUE(whole.unfinished.empty());
  EXPECT_EQ(cut_moved(whole.n_first_pairs).triangles, whole.triangles);
  ASSERT_GT(whole.n_first_pairs, 108U);
  const CutSurface given_up = cut_moved(1);
  EXPECT_FALSE(given_up.unfinished.empty());
  EXPECT_EQ(given_up.triangles, apart.triangles);
}

}  // namespace
}  // namespace meshalyzer
