#include "meshalyzer/repair/fix_defects.h"
#include "meshalyzer/repair/passes.h"
#include "support/boolean_results.h"
#include "support/intersecting_pairs.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"
#include "unit/repair/facets/mended_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The largest distance by which a vertex that stays was moved.
double largest_move(const Soup& before, const TrackedMesh& after) {
  double largest = 0.0;
  for (Index v = 0; v < after.soup.n_vertices(); ++v) {
    const Index key = after.vertex_keys[v];
    if (key >= before.n_vertices()) continue;
    largest = std::max(largest, (after.soup.positions[v] - before.positions[key]).norm());
  }
  return largest;
}

double tolerance_of(const Soup& soup) {
  return resolve_tolerances({}, box_of(soup)).degeneracy;
}

/// Expects the two solids of an hourglass to be apart, and sound.
void expect_cut_in_two(const Soup& soup) {
  const TopologyCounts topology = topology_of(soup);
  EXPECT_EQ(topology.components, 2U);
  EXPECT_EQ(topology.euler_characteristic, 4);
  EXPECT_EQ(topology.boundaries, 0U);
  EXPECT_EQ(topology.non_manifold_vertices, 0U);
  EXPECT_EQ(topology.flipped_edges, 0U);
  EXPECT_TRUE(thin_faces(soup).empty());
  EXPECT_EQ(n_intersecting_pairs(soup), 0U);
}

TEST(MendRemainingFacets, NeckThinnerThanTheToleranceIsCutAtItsVertices) {
  const Soup soup = hourglass({Vec3{1e-9, 0, 0}, Vec3{0, 1e-9, 0}, Vec3{0, -1e-9, 0}});
  ASSERT_EQ(topology_of(soup).euler_characteristic, 2);
  ASSERT_EQ(n_intersecting_pairs(soup), 0U);
  EXPECT_EQ(run_pass(soup, mend_facets).operations, 0U);
  const PassRun run = run_pass(soup, mend_remaining_facets);
  expect_cut_in_two(run.tracked.soup);
  EXPECT_EQ(run.tracked.soup.n_faces(), 8U);
  EXPECT_LE(largest_move(soup, run.tracked), 2e-9);
}

TEST(MendRemainingFacets, FlatNeckIsCutWithACopyOfItsFarVertex) {
  const Soup soup = hourglass({Vec3{1, 0, 0}, Vec3{0, 1e-9, 0}, Vec3{0, -1e-9, 0}});
  ASSERT_EQ(n_intersecting_pairs(soup), 0U);
  EXPECT_EQ(run_pass(soup, mend_facets).operations, 0U);
  const PassRun run = run_pass(soup, mend_remaining_facets);
  expect_cut_in_two(run.tracked.soup);
  EXPECT_LE(largest_move(soup, run.tracked), tolerance_of(soup));
}

TEST(MendRemainingFacets, WiderNeckIsKept) {
  const Soup soup = hourglass({Vec3{1e-6, 0, 0}, Vec3{0, 1e-6, 0}, Vec3{0, -1e-6, 0}});
  ASSERT_TRUE(thin_faces(soup).empty());
  EXPECT_TRUE(same_soup(run_pass(soup, mend_remaining_facets).tracked.soup, soup));
}

TEST(MendRemainingFacets, NeckWithAFixedVertexIsKept) {
  const Soup soup = hourglass({Vec3{1e-9, 0, 0}, Vec3{0, 1e-9, 0}, Vec3{0, -1e-9, 0}});
  RepairLimits limits = wide_limits(soup);
  limits.fixed_vertices.assign(soup.n_vertices(), 0);
  limits.fixed_vertices[1] = 1;
  EXPECT_TRUE(same_soup(run_pass(soup, mend_remaining_facets, limits).tracked.soup, soup));
}

/// A fan round a short edge, the upper end of which is the lower vertex number, and a small
/// triangle that lies between the heights of the two ends, over the faces of the other end.
Soup fan_under_triangle() {
  constexpr double kHeight = 1e-8;
  return shapes::make(
      {{1e-9, 0, kHeight},
       {0, 0, 0},
       {1, -1, 0},
       {1, 1, 0},
       {-1, 1, 0},
       {-1, -1, 0},
       {-0.1, -0.01, kHeight / 2},
       {-0.1, 0.01, kHeight / 2},
       {-0.9, 0, kHeight / 2}},
      {{0, 2, 3}, {0, 3, 1}, {1, 3, 4}, {1, 4, 5}, {1, 5, 2}, {1, 2, 0}, {6, 7, 8}});
}

TEST(MendRemainingFacets, EndOfAShortEdgeStaysThatMakesNoContact) {
  std::size_t n_usual = 0;
  for (const bool is_upper_first : {true, false}) {
    Soup soup = fan_under_triangle();
    if (!is_upper_first) {
      std::swap(soup.positions[0], soup.positions[1]);
      for (Triangle& t : soup.triangles) {
        for (Index& v : t) v = v < 2 ? 1 - v : v;
      }
    }
    ASSERT_EQ(thin_faces(soup).size(), 2U);
    ASSERT_EQ(n_intersecting_pairs(soup), 0U);
    n_usual += n_intersecting_pairs(run_pass(soup, mend_facets).tracked.soup);
    const PassRun run = run_pass(soup, mend_remaining_facets);
    EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
    EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
  }
  // By itself, one end is as good as the other.
  EXPECT_GT(n_usual, 0U);
}

/// A sliver of a tetrahedron with a short edge, over the unit cube at a height.
Soup cube_and_sliver(double height) {
  Soup soup = shapes::cube();
  const auto v = static_cast<Index>(soup.n_vertices());
  const double z = box_of(soup).max()[2] + height;
  soup.positions.insert(soup.positions.end(),
                        {{0.2, 0.2, z}, {0.6, 0.2, z}, {0.4, 0.5, z}, {0.4, 0.5, z + 1e-9}});
  soup.triangles.insert(
      soup.triangles.end(),
      {{v, v + 2, v + 1}, {v, v + 1, v + 3}, {v + 1, v + 2, v + 3}, {v + 2, v, v + 3}});
  return soup;
}

TEST(MendRemainingFacets, ClosedPartWithoutABodyIsDroppedWithinTheDeviationOfTheRest) {
  const Soup near = cube_and_sliver(0.001);
  ASSERT_EQ(thin_faces(near).size(), 2U);
  EXPECT_TRUE(same_soup(run_pass(near, mend_remaining_facets).tracked.soup, shapes::cube()));
  const Soup far = cube_and_sliver(0.5);
  EXPECT_TRUE(same_soup(run_pass(far, mend_remaining_facets).tracked.soup, far));
}

TEST(MendRemainingFacets, ClosedPartWithABodyIsKept) {
  Soup small = shapes::cube();
  split_edge(small, 0, 0, 1e-7);
  for (Vec3& p : small.positions) p = Vec3(0.3, 0.3, 1.001) + 0.004 * p;
  const Soup soup = shapes::merged(shapes::cube(), small);
  ASSERT_EQ(thin_faces(soup).size(), 2U);
  const PassRun run = run_pass(soup, mend_remaining_facets);
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  EXPECT_EQ(run.tracked.soup.n_faces(), 24U);
}

TEST(MendRemainingFacets, MendsAsUsualWhereNothingIsNear) {
  std::mt19937 random(5);
  for (int i = 0; i < 20; ++i) {
    Soup soup = shapes::icosphere(2);
    hurt(soup, 12, random);
    const PassRun run = run_pass(soup, mend_remaining_facets);
    EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
    EXPECT_EQ(topology_of(run.tracked.soup), topology_of(soup));
    EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
  }
}

constexpr std::array kBothTurnings{TurningOver::Forbidden, TurningOver::Permitted};

PassFunction widening(TurningOver turning) {
  return [turning](const PassInput& input) { return widen_facets(input, turning); };
}

TEST(WidenFacets, NothingIsProposedForASoundMesh) {
  const Soup soup = shapes::torus(3.0, 1.0, 16, 9);
  for (const TurningOver turning : kBothTurnings) {
    EXPECT_EQ(run_pass(soup, widening(turning)).operations, 0U);
  }
}

TEST(WidenFacets, NeedlesAndCapsBecomeAsWideAsTheTolerance) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    Soup soup = shapes::icosphere(2);
    const Index face = below(random, static_cast<Index>(soup.n_faces()));
    const double share = below(random, 2) == 0 ? 1e-10 : 0.3;
    const bool is_needle = below(random, 2) == 0;
    SCOPED_TRACE(testing::Message() << (is_needle ? "needle" : "cap") << share);
    if (is_needle) {
      split_edge(soup, face, below(random, 3), 1e-10);
    } else {
      add_cap(soup, face, below(random, 3), share);
    }
    ASSERT_FALSE(thin_faces(soup).empty());
    for (const TurningOver turning : kBothTurnings) {
      const PassRun run = run_pass(soup, widening(turning));
      EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
      EXPECT_EQ(run.tracked.soup.triangles, soup.triangles);
      EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
      EXPECT_LE(largest_move(soup, run.tracked), 8 * tolerance_of(soup));
      EXPECT_GT(largest_move(soup, run.tracked), 0.0);
    }
  }
}

TEST(WidenFacets, NeckIsWidenedWhereItCannotBeCut) {
  const Soup soup = hourglass({Vec3{1, 0, 0}, Vec3{0, 1e-9, 0}, Vec3{0, -1e-9, 0}});
  const PassRun run = run_pass(soup, widening(TurningOver::Forbidden));
  EXPECT_TRUE(thin_faces(run.tracked.soup).empty());
  EXPECT_EQ(topology_of(run.tracked.soup), topology_of(soup));
  EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
}

TEST(WidenFacets, FixedVerticesStay) {
  Soup soup = shapes::icosphere(1);
  split_edge(soup, 7, 1, 1e-10);
  RepairLimits limits = wide_limits(soup);
  limits.fixed_vertices.assign(soup.n_vertices(), 1);
  EXPECT_EQ(run_pass(soup, widening(TurningOver::Forbidden), limits).operations, 0U);
}

TEST(WidenFacets, NothingMovesFartherThanTheMaximumDeviation) {
  Soup soup = shapes::icosphere(1);
  split_edge(soup, 7, 1, 1e-10);
  RepairLimits limits = wide_limits(soup);
  limits.max_deviation = tolerance_of(soup) / 2;
  EXPECT_EQ(run_pass(soup, widening(TurningOver::Forbidden), limits).operations, 0U);
}

TEST(WidenFacets, NoContactIsMadeWithLayersCloserThanTheTolerance) {
  const auto layer = [](double scale) {
    Soup soup = shapes::icosphere(1);
    for (Vec3& p : soup.positions) p *= scale;
    return soup;
  };
  std::mt19937 random(11);
  std::size_t n_operations = 0;
  for (int i = 0; i < 30; ++i) {
    Soup soup = layer(1.0);
    const Index face = below(random, static_cast<Index>(soup.n_faces()));
    if (i % 2 == 0) {
      split_edge(soup, face, 0, 1e-10);
    } else {
      add_cap(soup, face, 0, 0.3);
    }
    soup = shapes::merged(shapes::merged(std::move(soup), layer(1 - 1e-9)), layer(1 + 1e-9));
    ASSERT_EQ(n_intersecting_pairs(soup), 0U);
    for (const TurningOver turning : kBothTurnings) {
      const PassRun run = run_pass(soup, widening(turning));
      EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
      n_operations += run.operations;
    }
  }
  EXPECT_GT(n_operations, 20U);
}

/// A tetrahedron with one corner at the origin and three within a few tolerances of (1, 0, 0).
Soup spike(std::mt19937& random) {
  Soup soup;
  soup.positions = {Vec3::Zero()};
  for (int i = 0; i < 3; ++i) {
    const Vec3 offset(below(random, 40), below(random, 40), below(random, 40));
    soup.positions.emplace_back(Vec3::UnitX() + 1e-9 * offset);
  }
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return volume_of(soup) > 0.0 ? soup : shapes::flipped(soup);
}

TEST(WidenFacets, MoreOfASpikeBecomesWideIfItsFacesMayTurnOver) {
  std::mt19937 random(5);
  constexpr std::size_t kSpikes = 200;
  std::array<std::size_t, 2> n_sound{};
  for (std::size_t i = 0; i < kSpikes; ++i) {
    const Soup soup = spike(random);
    for (const TurningOver turning : kBothTurnings) {
      const PassRun run = run_pass(soup, widening(turning));
      const std::vector<Index> left = thin_faces(run.tracked.soup);
      EXPECT_LE(left.size(), thin_faces(soup).size());
      EXPECT_EQ(n_intersecting_pairs(run.tracked.soup), 0U);
      EXPECT_LE(largest_move(soup, run.tracked), 20 * tolerance_of(soup));
      n_sound.at(static_cast<std::size_t>(turning)) += left.empty() ? 1U : 0U;
    }
  }
  EXPECT_LT(n_sound[0], kSpikes);
  EXPECT_EQ(n_sound[1], kSpikes);
}

TEST(FixDefects, NecksAndSliversThatCollapseCannotMendAreMended) {
  for (const Soup& soup : {hourglass({Vec3{1e-9, 0, 0}, Vec3{0, 1e-9, 0}, Vec3{0, -1e-9, 0}}),
                           hourglass({Vec3{1, 0, 0}, Vec3{0, 1e-9, 0}, Vec3{0, -1e-9, 0}}),
                           cube_and_sliver(0.0005), cube_and_sliver(0.5)}) {
    const Soup repaired = fix_defects(soup).meshes.front().tracked.soup;
    EXPECT_TRUE(thin_faces(repaired).empty());
    EXPECT_EQ(n_intersecting_pairs(repaired), 0U);
  }
}

/// Boxes with corners on a lattice, but for a deviation, so that many of their faces nearly
/// coincide.
Soup boxes_on_a_lattice(std::size_t n, double deviation, std::mt19937& random) {
  const auto below_as_real = [&](Index end) { return static_cast<double>(below(random, end)); };
  Soup soup;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 low(below_as_real(4), below_as_real(4), below_as_real(4));
    const Vec3 size(1 + below_as_real(3), 1 + below_as_real(3), 1 + below_as_real(3));
    Soup box = shapes::cube();
    for (Vec3& p : box.positions) {
      p = low + p.cwiseProduct(size);
      for (double& x : p) x += deviation * (below_as_real(2001) / 1000.0 - 1.0);
    }
    soup = shapes::merged(std::move(soup), box);
  }
  return soup;
}

TEST(FixDefects, BoxesThatNearlyShareFacesAreUnitedWithoutThinFacets) {
  std::mt19937 random(1);
  for (int i = 0; i < 30; ++i) {
    const Soup repaired = fix_defects(boxes_on_a_lattice(6, 1e-10, random)).meshes[0].tracked.soup;
    EXPECT_TRUE(thin_faces(repaired).empty());
    EXPECT_EQ(n_intersecting_pairs(repaired), 0U);
    EXPECT_EQ(topology_of(repaired).boundaries, 0U);
  }
}

}  // namespace
}  // namespace meshalyzer
