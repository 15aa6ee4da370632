#include "meshalyzer/spatial/self_intersection.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/face_groups.h"
#include "meshalyzer/spatial/pair_collector.h"
#include "support/effort.h"
#include "support/exact_oracle.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "support/sliver_tube.h"
#include "unit/spatial/pairs_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

constexpr unsigned kSeed = 20261121;
using Random = std::mt19937;

Pairs self_intersections(const Soup& soup) {
  const CutMesh cut = build(soup);
  return find_self_intersections(cut, FaceTree(cut));
}

/// Two faces with their common vertices first, `same` telling what common means.
struct Aligned {
  Triangle p;
  Triangle q;
  int n_common = 0;
};

Aligned aligned(const Triangle& p, const Triangle& q,
                const std::function<bool(Index, Index)>& same) {
  Aligned best;
  std::array<int, 3> order{0, 1, 2};
  const auto pick = [](const Triangle& t, const std::array<int, 3>& o) {
    return Triangle{t[static_cast<std::size_t>(o[0])], t[static_cast<std::size_t>(o[1])],
                    t[static_cast<std::size_t>(o[2])]};
  };
  best = {p, q, -1};
  do {
    std::array<int, 3> other{0, 1, 2};
    do {
      const Triangle a = pick(p, order);
      const Triangle b = pick(q, other);
      int n = 0;
      while (n < 3 && same(a[static_cast<std::size_t>(n)], b[static_cast<std::size_t>(n)])) {
        ++n;
      }
      if (n > best.n_common) {
        best = {a, b, n};
      }
    } while (std::next_permutation(other.begin(), other.end()));
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

std::optional<ContactKind> oracle(const Soup& soup, const Aligned& pair) {
  const auto corners = [&](const Triangle& t) {
    return Corners{soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]};
  };
  return test::oracle_contact(corners(pair.p), corners(pair.q), static_cast<Common>(pair.n_common));
}

/// All pairs, straight from "Intersecting faces" in doc/definitions.md, evaluated over the
/// rationals.
Pairs brute_force(const Soup& soup) {
  Pairs pairs;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    for (Index g = f + 1; g < soup.n_faces(); ++g) {
      const Triangle& p = soup.triangles[f];
      const Triangle& q = soup.triangles[g];
      if (!is_in_complex(p) || !is_in_complex(q) ||
          !box_of(corners_of(soup, f)).intersects(box_of(corners_of(soup, g)))) {
        continue;
      }
      const Aligned by_id = aligned(p, q, [](Index a, Index b) { return a == b; });
      const auto kind = oracle(soup, by_id);
      if (!kind) {
        continue;
      }
      const Aligned by_place =
          aligned(p, q, [&](Index a, Index b) { return soup.positions[a] == soup.positions[b]; });
      const bool unwelded = by_place.n_common > by_id.n_common && !oracle(soup, by_place);
      pairs.push_back({f, g, unwelded ? ContactKind::Unwelded : *kind});
    }
  }
  return pairs;
}

Soup random_soup(std::size_t n_vertices, std::size_t n_faces,
                 const std::function<Vec3(Random&)>& point, Random& random) {
  Soup soup;
  for (std::size_t i = 0; i < n_vertices; ++i) {
    soup.positions.push_back(point(random));
  }
  std::uniform_int_distribution<Index> vertex(0, static_cast<Index>(n_vertices - 1));
  for (std::size_t i = 0; i < n_faces; ++i) {
    soup.triangles.push_back({vertex(random), vertex(random), vertex(random)});
  }
  return soup;
}

void expect_brute_force(const std::function<Vec3(Random&)>& point) {
  Random random(kSeed);
  for (std::size_t round = 0; round < 12; round += test::one_of()) {
    const Soup soup = random_soup(14, 40, point, random);
    const Pairs expected = brute_force(soup);
    ASSERT_EQ(listed(self_intersections(soup)), listed(expected))
        << "round " << round << " seed " << kSeed;
    EXPECT_FALSE(expected.empty());
  }
}

TEST(FindSelfIntersections, EqualsBruteForceOnRandomSoups) {
  const auto real = [](Random& r) { return std::uniform_real_distribution<>(-1, 1)(r); };
  expect_brute_force([&](Random& r) { return Vec3(real(r), real(r), real(r)); });
}

TEST(FindSelfIntersections, EqualsBruteForceOnLatticesWhereNearlyAllIsCoplanarOrTouching) {
  expect_brute_force([](Random& r) { return Vec3(lattice(r, 3), lattice(r, 3), lattice(r, 3)); });
  expect_brute_force([](Random& r) { return Vec3(lattice(r, 4), lattice(r, 4), 0); });
  expect_brute_force([](Random& r) { return Vec3(lattice(r, 3), lattice(r, 3), lattice(r, 2)); });
}

TEST(FindSelfIntersections, EqualsBruteForceNearlyInOnePlane) {
  expect_brute_force([](Random& r) {
    const double x = 0.1 * lattice(r, 4);
    const double y = 0.1 * lattice(r, 4);
    return Vec3(x, y, 0.3 * x + 0.7 * y);
  });
}

TEST(FindSelfIntersections, EqualsBruteForceOneUlpFromTouching) {
  expect_brute_force([](Random& r) {
    const auto nudged = [&r](double x) { return r() % 3 == 0 ? std::nextafter(x, 9.0) : x; };
    return Vec3(nudged(lattice(r, 3)), nudged(lattice(r, 3)), nudged(lattice(r, 3)));
  });
}

TEST(FindSelfIntersections, EqualsBruteForceFarFromTheOrigin) {
  expect_brute_force([](Random& r) {
    return Vec3(1e9 + lattice(r, 3), 1e9 - lattice(r, 3), 1e-3 * lattice(r, 3));
  });
}

TEST(FindSelfIntersections, ClosedGoodMeshesHaveNone) {
  for (const Soup& soup :
       {shapes::cube(), shapes::uv_sphere(20, 30), shapes::icosphere(3),
        shapes::torus(2, 0.5, 30, 20), shapes::genus_block(3), shapes::grid(20, 20),
        shapes::nested_cubes(shapes::InnerShell::Cavity)}) {
    EXPECT_EQ(listed(self_intersections(soup)), "");
  }
}

TEST(FindSelfIntersections, MeshesOfManyLeavesEqualBruteForce) {
  // Two spheres through each other: enough faces for a tree of several levels.
  const std::size_t rings = test::one_of() == 1 ? 9 : 4;
  const Soup soup =
      shapes::merged(shapes::uv_sphere(rings, 14),
                     shapes::translated(shapes::uv_sphere(rings - 1, 13), {0.9, 0.3, 0.2}));
  const Pairs expected = brute_force(soup);
  EXPECT_GT(expected.size(), 20u);
  EXPECT_EQ(listed(self_intersections(soup)), listed(expected));
}

TEST(FindSelfIntersections, MeshesWithFarVerticesEqualBruteForce) {
  Soup spheres = shapes::merged(shapes::uv_sphere(7, 10),
                                shapes::translated(shapes::uv_sphere(6, 9), {0.9, 0.3, 0.2}));
  Soup slivers = test::sliver_tube(40, {20, 22, 18});
  Soup tangle = shapes::tangle(100);
  for (Soup* soup : {&spheres, &slivers, &tangle}) {
    soup->positions[20] = {1e28, 0, 0};
    soup->positions[40] = {3, -1e7, 2};
    const CutMesh cut = build(*soup);
    const FaceTree tree(cut);
    EXPECT_TRUE(tree.has_far_faces());
    const Pairs expected = brute_force(*soup);
    EXPECT_GT(expected.size(), 5u);
    EXPECT_EQ(find_self_intersections(cut, tree), expected);
  }
}

TEST(FindSelfIntersections, BundlesOfSliversEqualBruteForce) {
  const std::size_t sides = test::one_of() == 1 ? 120 : 30;
  const Soup one = test::sliver_tube(sides, {20, 22, 18});
  EXPECT_EQ(listed(self_intersections(one)), "");
  const Soup two = shapes::merged(
      one, shapes::translated(test::sliver_tube(sides / 2, {20, 21, 19}), {0.3, -0.4, 0.1}));
  const Pairs expected = brute_force(two);
  EXPECT_GT(expected.size(), 10u);
  EXPECT_EQ(listed(self_intersections(two)), listed(expected));
}

/// n faces round one vertex; of every `bent` points of the rim two are pulled far out of line (0:
/// none).
Soup wide_fan(std::size_t n, std::size_t bent) {
  Soup soup;
  soup.positions = {Vec3(0, 0, 1)};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    const double turn = bent != 0 && i % bent == 1 ? angle + 0.4 : angle;
    soup.positions.emplace_back(std::cos(turn), std::sin(turn),
                                bent != 0 && i % bent == 2 ? 0.9 : 0.0);
  }
  for (std::size_t i = 0; i < n; ++i) {
    soup.triangles.push_back({0, static_cast<Index>(1 + i), static_cast<Index>(1 + (i + 1) % n)});
  }
  return soup;
}

/// Two fans round vertex 0: n wide faces in the plane z = 0, and n small ones that pass through it.
Soup fan_through_fan(std::size_t n) {
  Soup soup;
  soup.positions = {Vec3(0, 0, 0)};
  const auto add_fan = [&](const Vec3& u, const Vec3& v) {
    const auto first = static_cast<Index>(soup.n_vertices());
    for (std::size_t i = 0; i <= n; ++i) {
      const double angle = 2.0 * static_cast<double>(i) / static_cast<double>(n) - 0.9;
      soup.positions.emplace_back(std::cos(angle) * u + std::sin(angle) * v);
    }
    for (Index i = 0; i < n; ++i) {
      soup.triangles.push_back({0, first + i, first + i + 1});
    }
  };
  add_fan({100, 0, 0}, {0, 100, 0});
  add_fan({1, 0.1, 0}, {0, 0, 1});
  return soup;
}

TEST(FindSelfIntersections, SmallFanThroughAWideOneEqualsBruteForce) {
  const Soup soup = fan_through_fan(64);
  const Pairs expected = brute_force(soup);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(listed(self_intersections(soup)), listed(expected));
}

TEST(FindSelfIntersections, WideFansEqualBruteForce) {
  EXPECT_EQ(listed(self_intersections(wide_fan(200, 0))), "");
  const Soup bent = wide_fan(160, 16);
  const Pairs expected = brute_force(bent);
  EXPECT_GE(expected.size(), 10u);
  EXPECT_EQ(listed(self_intersections(bent)), listed(expected));
}

TEST(FindSelfIntersections, ThreadCountDoesNotMatter) {
  const Soup soup = shapes::merged(shapes::uv_sphere(90, 90),
                                   shapes::translated(shapes::uv_sphere(80, 90), {0.9, 0.3, 0.2}));
  Pairs by_one;
  {
    const ThreadLimit one(1);
    by_one = self_intersections(soup);
  }
  const ThreadLimit two(2);
  EXPECT_EQ(listed(self_intersections(soup)), listed(by_one));
  EXPECT_FALSE(by_one.empty());
}

TEST(FindSelfIntersections, FaceOrderMovesOnlyTheNumbers) {
  const Soup soup = shapes::merged(shapes::uv_sphere(9, 14),
                                   shapes::translated(shapes::uv_sphere(8, 13), {0.9, 0.3, 0.2}));
  std::vector<Index> order(soup.n_faces());
  std::iota(order.begin(), order.end(), Index{0});
  Random random(kSeed);
  std::shuffle(order.begin(), order.end(), random);
  Soup shuffled = soup;
  for (std::size_t i = 0; i < order.size(); ++i) {
    shuffled.triangles[i] = soup.triangles[order[i]];
  }
  Pairs back = self_intersections(shuffled);
  for (IntersectingPair& pair : back) {
    const auto [low, high] = std::minmax(order[pair.face_a], order[pair.face_b]);
    pair = {low, high, pair.kind};
  }
  std::sort(back.begin(), back.end(), [](const IntersectingPair& a, const IntersectingPair& b) {
    return std::pair(a.face_a, a.face_b) < std::pair(b.face_a, b.face_b);
  });
  EXPECT_EQ(listed(back), listed(self_intersections(soup)));
}

TEST(FindSelfIntersections, SeamThatWasNeverWeldedIsUnwelded) {
  // Two triangles of a square, each with vertices of its own.
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                 {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(listed(self_intersections(soup)), "0-1 unwelded\n");
}

TEST(FindSelfIntersections, UnweldedNeighbourFoldedOverIsNoSeam) {
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                                 {{0, 1, 2}, {4, 3, 5}});
  EXPECT_EQ(listed(self_intersections(soup)), "0-1 coplanar-overlap\n");
}

TEST(FindSelfIntersections, PillowIsDuplicate) {
  EXPECT_EQ(listed(self_intersections(shapes::pillow())), "0-1 duplicate\n");
}

TEST(FindSelfIntersections, EmptyAndSingleFaceMeshesHaveNone) {
  EXPECT_EQ(listed(self_intersections(Soup())), "");
  EXPECT_EQ(
      listed(self_intersections(shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}))), "");
}

TEST(FindSelfIntersections, SearchThatEndsEarlyFindsTheSameForAnyNumberOfThreads) {
  // Two grids across each other, each of its own: 2 * 60 * 60 faces, far more than one round.
  Soup across = shapes::grid(60, 60);
  for (Vec3& p : across.positions) p = Vec3(p.x(), p.z() + 30.5, p.y() - 30.5);
  const CutMesh cut = build(shapes::merged(shapes::grid(60, 60), across));
  const FaceTree tree(cut);
  const Pairs all = find_self_intersections(cut, tree);
  ASSERT_GT(all.size(), 100U);
  const auto some_with = [&](std::size_t n_threads) {
    const ThreadLimit limit(n_threads);
    return find_self_intersections(cut, tree, {.max_found = 20, .wants_to_stop = {}}).listed;
  };
  const Pairs some = some_with(1);
  EXPECT_EQ(some.size(), 20U);
  EXPECT_EQ(listed(some), listed(some_with(4)));
  const FoundPairs complete =
      find_self_intersections(cut, tree, {.max_found = all.size() + 1, .wants_to_stop = {}});
  EXPECT_TRUE(complete.is_complete);
  EXPECT_EQ(listed(complete.listed), listed(all));
}

/// Adds faces at the places of a triangle: with its three vertices, or each with vertices of its
/// own.
void add_copies(Soup& soup, const Corners& corners, std::size_t n, bool have_own_vertices) {
  for (std::size_t i = 0; i < n; ++i) {
    if (i == 0 || have_own_vertices) {
      soup.positions.insert(soup.positions.end(), corners.begin(), corners.end());
    }
    const auto first = static_cast<Index>(soup.n_vertices() - 3);
    // Each begins with another corner, and every other one is turned.
    const Index a = first + static_cast<Index>(i % 3);
    const Index b = first + static_cast<Index>((i + 1) % 3);
    const Index c = first + static_cast<Index>((i + 2) % 3);
    soup.triangles.push_back(i % 2 == 0 ? Triangle{a, b, c} : Triangle{a, c, b});
  }
}

/// Faces that are crowded at a few places: equal ones, of no area, at one point; among others.
Soup piles() {
  const Vec3 o(0.5, 0.5, 0.5);
  Soup soup = shapes::tangle(12);
  add_copies(soup, {o, o, o}, 40, true);
  add_copies(soup, {o, o, o}, 33, false);
  add_copies(soup, {Vec3(0, 0, 0), o, Vec3(1, 1, 1)}, 29, true);
  add_copies(soup, {Vec3(0, 0, 0.5), Vec3(1, 0, 0.5), Vec3(0.5, 1, 0.5)}, 31, true);
  add_copies(soup, {Vec3(0, 0, 0.5), Vec3(1, 0, 0.5), Vec3(0.5, 1, 0.5)}, 27, false);
  add_copies(soup, {Vec3(0.5, 0, 0), Vec3(0.5, 1, 0), Vec3(0.5, 0.5, 1)}, 5, true);
  // A surface that has collapsed into a point: its faces have vertices in common.
  Soup collapsed = shapes::grid(4, 4);
  for (Vec3& p : collapsed.positions) p = o;
  soup = shapes::merged(soup, collapsed);
  // A face that hangs on the vertices of a pile.
  soup.positions.emplace_back(2, 2, 2);
  soup.triangles.push_back({36, 37, static_cast<Index>(soup.n_vertices() - 1)});
  return soup;
}

TEST(FindSelfIntersections, PilesOfEqualFacesEqualBruteForce) {
  test::Effort effort;
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    if (!effort.runs_next()) continue;
    const Soup soup = shapes::shuffled_faces(piles(), seed);
    const Pairs expected = brute_force(soup);
    EXPECT_EQ(listed(self_intersections(soup)), listed(expected));
    const CutMesh cut = build(soup);
    const FaceTree tree(cut);
    EXPECT_GE(FaceGroups(cut, tree).size(), 4U);
    ASSERT_GT(expected.size(), 5000U);
    for (const std::size_t max_listed : {0, 1, 100, 5000}) {
      PairCollector collector(max_listed);
      EXPECT_TRUE(visit_self_intersections(cut, tree, PairLimits(), collector));
      const FoundPairs found = collector.take();
      EXPECT_EQ(found.counts.total(), expected.size());
      EXPECT_EQ(listed(found.listed),
                listed(Pairs(expected.begin(), expected.begin() + static_cast<int>(max_listed))));
    }
  }
}

TEST(FindSelfIntersections, HugePilesAreCountedNotSearched) {
  Soup soup;
  add_copies(soup, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, 30000, true);
  add_copies(soup, {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, 30000, false);
  const CutMesh cut = build(soup);
  PairCollector collector(10);
  EXPECT_TRUE(visit_self_intersections(cut, FaceTree(cut), PairLimits(), collector));
  const FoundPairs found = collector.take();
  constexpr std::size_t kWithin = std::size_t{30000} * 29999 / 2;
  EXPECT_EQ(found.counts.of(ContactKind::Duplicate), kWithin);
  EXPECT_EQ(found.counts.total(), 2 * kWithin + std::size_t{30000} * 30000);
  EXPECT_EQ(found.listed.front().face_b, 1U);
  EXPECT_EQ(found.listed.back().face_b, 10U);
}

TEST(VisitSelfIntersections, HandsOnEachPairOnce) {
  const Soup soup = shapes::tangle(300);
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  PairCollector collector(kAllPairs);
  EXPECT_TRUE(visit_self_intersections(cut, tree, PairLimits(), collector));
  EXPECT_EQ(listed(collector.take().listed), listed(brute_force(soup)));
}

TEST(VisitSelfIntersections, EndsWhenItIsToldToStop) {
  const CutMesh cut = build(shapes::tangle(1000));
  const FaceTree tree(cut);
  std::atomic<int> n_asked = 0;
  const PairLimits limits{.wants_to_stop = [&] { return ++n_asked == 20; }};
  PairCollector collector(kAllPairs);
  EXPECT_FALSE(visit_self_intersections(cut, tree, limits, collector));
  const std::size_t n_found = collector.take().counts.total();
  EXPECT_GT(n_found, 0U);
  EXPECT_LT(n_found, find_self_intersections(cut, tree).size());
}

}  // namespace
}  // namespace meshalyzer
