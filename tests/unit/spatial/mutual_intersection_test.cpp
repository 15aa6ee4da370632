#include "meshalyzer/spatial/mutual_intersection.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "meshalyzer/spatial/triangle_contact.h"
#include "support/exact_oracle.h"
#include "support/random_soups.h"
#include "support/shapes.h"
#include "support/sliver_tube.h"
#include "unit/spatial/pairs_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

constexpr unsigned kMutualSeed = 20261124;
using Random = std::mt19937;

/// A mesh with its tree, which refers to it.
struct Mesh {
  explicit Mesh(const Soup& soup) : cut(build(soup)), tree(cut) {}
  CutMesh cut;
  FaceTree tree;
};

Pairs intersections(const Soup& a, const Soup& b) {
  const Mesh x(a);
  const Mesh y(b);
  return find_intersections(x.cut, x.tree, y.cut, y.tree);
}

bool intersect(const Soup& a, const Soup& b) {
  return do_intersect(Mesh(a).tree, Mesh(b).tree);
}

/// All pairs, straight from "Intersecting faces" in doc/definitions.md, evaluated over the
/// rationals or by another judge.
Pairs brute_force(const Soup& a, const Soup& b,
                  decltype(find_contact)& judge = test::oracle_contact) {
  Pairs pairs;
  for (Index f = 0; f < a.n_faces(); ++f) {
    for (Index g = 0; g < b.n_faces(); ++g) {
      if (!is_in_complex(a.triangles[f]) || !is_in_complex(b.triangles[g])) {
        continue;
      }
      const Corners p = corners_of(a, f);
      const Corners q = corners_of(b, g);
      if (!box_of(p).intersects(box_of(q))) continue;
      if (const auto kind = judge(p, q, Common::Nothing)) {
        const bool same = std::is_permutation(p.begin(), p.end(), q.begin());
        pairs.push_back({f, g, same ? ContactKind::Duplicate : *kind});
      }
    }
  }
  return pairs;
}

Pairs mirrored(Pairs pairs) {
  for (IntersectingPair& pair : pairs) {
    std::swap(pair.face_a, pair.face_b);
  }
  std::sort(pairs.begin(), pairs.end(), [](const IntersectingPair& p, const IntersectingPair& q) {
    return std::pair(p.face_a, p.face_b) < std::pair(q.face_a, q.face_b);
  });
  return pairs;
}

/// Checks both functions, both ways round, and returns how many pairs there are.
std::size_t expect_pairs(const Soup& a, const Soup& b, const Pairs& expected) {
  EXPECT_EQ(listed(intersections(a, b)), listed(expected));
  EXPECT_EQ(listed(intersections(b, a)), listed(mirrored(expected)));
  EXPECT_EQ(intersect(a, b), !expected.empty());
  EXPECT_EQ(intersect(b, a), !expected.empty());
  return expected.size();
}

std::size_t expect_brute_force(const Soup& a, const Soup& b) {
  return expect_pairs(a, b, brute_force(a, b));
}

using Place = std::function<Vec3(Random&)>;

Soup random_soup(std::size_t n_faces, const Place& place, Random& random) {
  constexpr Index kVertices = 14;
  Soup soup;
  for (Index i = 0; i < kVertices; ++i) {
    soup.positions.push_back(place(random));
  }
  std::uniform_int_distribution<Index> vertex(0, kVertices - 1);
  for (std::size_t i = 0; i < n_faces; ++i) {
    soup.triangles.push_back({vertex(random), vertex(random), vertex(random)});
  }
  return soup;
}

/// Random soups of unequal size, their vertices at these places: some pairs, and not all of them.
void expect_brute_force_on_soups(const Place& in_a, const Place& in_b) {
  Random random(kMutualSeed);
  std::size_t n_pairs = 0;
  for (int round = 0; round < 5; ++round) {
    SCOPED_TRACE("round " + std::to_string(round) + " seed " + std::to_string(kMutualSeed));
    n_pairs += expect_brute_force(random_soup(24, in_a, random), random_soup(15, in_b, random));
  }
  EXPECT_GT(n_pairs, 0u);
  EXPECT_LT(n_pairs, 5u * 24u * 15u);
}

double real(Random& random) {
  return std::uniform_real_distribution<>(-1, 1)(random);
}
Vec3 anywhere(Random& r) {
  return {real(r), real(r), real(r)};
}
Vec3 on_lattice(Random& r) {
  return {lattice(r, 3), lattice(r, 3), lattice(r, 3)};
}
Place times(const Place& place, double factor) {
  return [=](Random& r) { return Vec3(place(r) * factor); };
}
Place moved(const Place& place, const Vec3& by) {
  return [=](Random& r) { return Vec3(place(r) + by); };
}

TEST(FindIntersections, EqualsBruteForceOnRandomSoups) {
  expect_brute_force_on_soups(anywhere, anywhere);
  expect_brute_force_on_soups(anywhere, moved(anywhere, {1.2, 0.8, -0.3}));
}

TEST(FindIntersections, EqualsBruteForceOnLatticesWhereNearlyAllTouches) {
  expect_brute_force_on_soups(on_lattice, on_lattice);
  expect_brute_force_on_soups(on_lattice, moved(on_lattice, {2, 1, 0}));
  expect_brute_force_on_soups(on_lattice, moved(on_lattice, {0.5, 0.5, 0.5}));
}

TEST(FindIntersections, EqualsBruteForceInOnePlane) {
  const Place flat = [](Random& r) { return Vec3(lattice(r, 4), lattice(r, 4), 0); };
  expect_brute_force_on_soups(flat, flat);
  expect_brute_force_on_soups(flat, moved(flat, {0.5, 1, 0}));
  const Place nearly_flat = [](Random& r) {
    const double x = 0.1 * lattice(r, 4);
    const double y = 0.1 * lattice(r, 4);
    return Vec3(x, y, 0.3 * x + 0.7 * y);
  };
  expect_brute_force_on_soups(nearly_flat, nearly_flat);
}

TEST(FindIntersections, EqualsBruteForceOnOneLineAndInOnePoint) {
  const Place line = [](Random& r) { return Vec3(lattice(r, 9) * Vec3(1, 2, 3)); };
  expect_brute_force_on_soups(line, on_lattice);
  expect_brute_force_on_soups(line, line);
  const Soup point = shapes::make({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}});
  Random random(kMutualSeed);
  EXPECT_GT(expect_brute_force(point, random_soup(30, on_lattice, random)), 0u);
}

TEST(FindIntersections, EqualsBruteForceOneUlpFromTouching) {
  const Place nudged = [](Random& r) {
    Vec3 p = on_lattice(r);
    for (double& x : p) {
      x = r() % 3 == 0 ? std::nextafter(x, 9.0) : x;
    }
    return p;
  };
  expect_brute_force_on_soups(nudged, moved(on_lattice, {2, 0, 0}));
  expect_brute_force_on_soups(nudged, nudged);
}

TEST(FindIntersections, EqualsBruteForceBetweenTheSmallestAndTheLargestNumbers) {
  const Place about_origin = moved(on_lattice, {-1, -1, -1});
  for (const auto& [large, small] :
       {std::pair(1.0, 1e-30), std::pair(1e9, 1e-310), std::pair(1e300, 1e-310),
        std::pair(8e307, 1e-320), std::pair(1e-300, 1e-310)}) {
    SCOPED_TRACE(std::to_string(std::log10(large)) + " " + std::to_string(std::log10(small)));
    expect_brute_force_on_soups(times(about_origin, large), times(about_origin, small));
  }
}

TEST(FindIntersections, EqualsBruteForceFarFromTheOrigin) {
  const Vec3 far(1e9, -1e9, 3e8);
  expect_brute_force_on_soups(moved(on_lattice, far), moved(times(on_lattice, 1e-6), far));
  const Place huge = times(on_lattice, 1e300);
  const Place tiny_at_its_corner = moved(times(on_lattice, 1e285), Vec3(2e300, 1e300, 0));
  expect_brute_force_on_soups(huge, tiny_at_its_corner);
}

TEST(FindIntersections, FacesThatReachFarAreMetFarAway) {
  // In the tree of the first mesh the end of its far face lies at the edge of the other faces.
  Soup mesh = shapes::grid(40, 40);
  mesh.positions.push_back(Vec3(1e9, 1e9, 1e9));
  mesh.triangles.push_back({0, 1, static_cast<Index>(mesh.positions.size() - 1)});
  ASSERT_TRUE(FaceTree(build(mesh)).has_far_faces());
  const Vec3 on_face(5e8 + 0.25, 5e8, 5e8);
  const Soup across = shapes::make(
      {on_face + Vec3(0, 9, -9), on_face + Vec3(0, -9, 9), on_face + Vec3(9, 9, 9)}, {{0, 1, 2}});
  EXPECT_EQ(expect_brute_force(mesh, across), 1U);
  EXPECT_EQ(expect_brute_force(across, mesh), 1U);
}

TEST(FindIntersections, FaceBeyondAllBoundsMeetsNoneThatAreNotThere) {
  // Its box under the map of the other mesh is all of space, and the other mesh's leaf has five
  // places without a face.
  constexpr double kMax = std::numeric_limits<double>::max();
  const Soup vast =
      shapes::make({{-kMax, -kMax, -kMax}, {kMax, kMax, kMax}, {kMax, -kMax, kMax}}, {{0, 1, 2}});
  const Soup tiny = shapes::scaled(shapes::tetrahedron(), 1e-300);
  // The origin and, with it, all faces but the one opposite to it. The vast face's plane is x = z,
  // and the opposite face, x + y + z = 1e-300, has a corner on either side of it and one in it, at
  // y = 1e-300, where the vast face is not (y <= x); but from the middle of the edge between the
  // corners (1, 0, 0) and (0, 0, 1) on it is.
  EXPECT_EQ(expect_brute_force(vast, tiny), 4u);
  EXPECT_EQ(expect_brute_force(vast, shapes::translated(tiny, {1, 0, 0})), 0u);
}

TEST(FindIntersections, MeshesOfSeveralLeavesEqualBruteForce) {
  const Soup sphere = shapes::uv_sphere(4, 7);
  EXPECT_GT(
      expect_brute_force(sphere, shapes::translated(shapes::uv_sphere(6, 9), {0.9, 0.3, 0.2})),
      20u);
  // Only one end of the pair of spheres is near the small one.
  const Soup pair = shapes::merged(sphere, shapes::translated(sphere, {50, 0, 0}));
  EXPECT_GT(expect_brute_force(pair, shapes::translated(shapes::scaled(sphere, 0.1), {50.9, 0, 0})),
            5u);
}

TEST(FindIntersections, LargeMeshesEqualTheSelfIntersectionsOfBothInOne) {
  // Neither sphere intersects itself, and they have no vertices at common places.
  const Soup a = shapes::uv_sphere(90, 90);
  const Soup b = shapes::translated(shapes::uv_sphere(50, 70), {0.9, 0.3, 0.2});
  const CutMesh both = build(shapes::merged(a, b));
  Pairs expected = find_self_intersections(both, FaceTree(both));
  for (IntersectingPair& pair : expected) {
    pair.face_b -= static_cast<Index>(a.n_faces());
  }
  EXPECT_GT(expect_pairs(a, b, expected), 300u);
}

TEST(FindIntersections, MeshAgainstItselfHasDuplicatesAndNeighbours) {
  // A convex mesh: two of its faces share points exactly where they share vertices.
  const Soup sphere = shapes::uv_sphere(9, 14);
  Pairs expected;
  for (Index f = 0; f < sphere.n_faces(); ++f) {
    for (Index g = 0; g < sphere.n_faces(); ++g) {
      const Triangle& p = sphere.triangles[f];
      const Triangle& q = sphere.triangles[g];
      if (std::find_first_of(p.begin(), p.end(), q.begin(), q.end()) != p.end()) {
        expected.push_back({f, g, f == g ? ContactKind::Duplicate : ContactKind::Touching});
      }
    }
  }
  EXPECT_GT(expect_pairs(sphere, sphere, expected), sphere.n_faces());
}

TEST(FindIntersections, DuplicatesAreFoundInAnyOrderOfCornersAndEitherWayRound) {
  const Soup cube = shapes::cube();
  const Soup other = shapes::renumbered_vertices(
      shapes::shuffled_faces(shapes::flipped(cube), kMutualSeed), kMutualSeed);
  const Pairs pairs = intersections(cube, other);
  const auto n = std::count_if(pairs.begin(), pairs.end(), [](const IntersectingPair& pair) {
    return pair.kind == ContactKind::Duplicate;
  });
  EXPECT_EQ(n, 12);
  expect_brute_force(cube, other);
}

TEST(FindIntersections, CommonEdgeByPlaceIsNoFoldOver) {
  const Soup face = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto with_third_corner = [](const Vec3& c) {
    return shapes::make({{1, 0, 0}, {0, 0, 0}, c}, {{0, 1, 2}});
  };
  EXPECT_EQ(listed(intersections(face, with_third_corner({1, 1, 0}))), "0-0 coplanar-overlap\n");
  EXPECT_EQ(listed(intersections(face, with_third_corner({0, -1, 0}))), "0-0 touching\n");
  EXPECT_EQ(listed(intersections(face, with_third_corner({0, 1, 1}))), "0-0 touching\n");
}

TEST(FindIntersections, FacesAreNamedByTheirFileAlsoWhereSomeAreRejected) {
  // The first record of each names a vertex twice and is in no complex.
  Soup a = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 1, 2}});
  Soup b =
      shapes::make({{0.2, 0.2, -1}, {0.2, 0.2, 1}, {0.2, 5, 0}}, {{1, 1, 1}, {2, 0, 0}, {0, 1, 2}});
  EXPECT_EQ(listed(intersections(a, b)), "1-2 crossing\n");
  EXPECT_EQ(listed(intersections(b, a)), "2-1 crossing\n");
}

/// For meshes too large for the oracle: only how pairs are found is in question here.
void expect_pairs_of_any_face_with_any(const Soup& a, const Soup& b) {
  EXPECT_GT(expect_pairs(a, b, brute_force(a, b, find_contact)), 10u);
}

TEST(FindIntersections, BundlesOfSliversEqualBruteForce) {
  const Soup tube = test::sliver_tube(250, {20, 22, 18});
  expect_pairs_of_any_face_with_any(
      tube, shapes::translated(test::sliver_tube(200, {20, 21, 19}), {0.3, -0.4, 0.1}));
  // Far longer than the other one, whose map takes its ends far out.
  expect_pairs_of_any_face_with_any(
      tube,
      shapes::translated(test::sliver_tube(200, {2000, 2150, 1850}), {-989.5, -1064.3, -915.9}));
}

TEST(FindIntersections, BundleOfSliversThroughFinerMeshEqualsBruteForce) {
  const Soup tube = shapes::translated(test::sliver_tube(200, {20, 22, 18}), {-10.1, -11.2, -9.3});
  expect_pairs_of_any_face_with_any(tube, shapes::scaled(shapes::uv_sphere(22, 24), 5));
}

TEST(FindIntersections, MeshInsideAnotherDoesNotMeetIt) {
  const Soup outer = shapes::icosphere(3);
  EXPECT_EQ(expect_pairs(outer, shapes::scaled(outer, 0.9), {}), 0u);
}

TEST(FindIntersections, EmptyMeshMeetsNothing) {
  const Soup no_face = shapes::make({{0, 0, 0}, {1, 0, 0}}, {});
  for (const Soup& empty : {Soup(), no_face}) {
    expect_pairs(empty, shapes::cube(), {});
    expect_pairs(empty, empty, {});
  }
}

TEST(FindIntersections, ThreadCountDoesNotMatter) {
  const Soup a = shapes::uv_sphere(90, 90);
  const Soup b = shapes::translated(shapes::uv_sphere(80, 90), {0.9, 0.3, 0.2});
  Pairs by_one;
  {
    const ThreadLimit one(1);
    by_one = intersections(a, b);
  }
  const ThreadLimit many(8);
  EXPECT_EQ(listed(intersections(a, b)), listed(by_one));
  EXPECT_FALSE(by_one.empty());
}

TEST(DoIntersect, OneContactAmongManyFacesIsFound) {
  const Soup ground = shapes::grid(80, 80);
  // Tetrahedra above the ground, one of which stands on it.
  Soup above = shapes::translated(shapes::tetrahedron(), {40.3, 40.6, 0});
  for (int i = 0; i < 70; ++i) {
    above = shapes::merged(above, shapes::translated(shapes::tetrahedron(), {1.0 * i, 7, 0.001}));
  }
  EXPECT_TRUE(intersect(ground, above));
  EXPECT_TRUE(intersect(above, ground));
  const double lifted = std::numeric_limits<double>::denorm_min();
  EXPECT_FALSE(intersect(ground, shapes::translated(above, {0, 0, lifted})));
}

TEST(CountIntersections, CountsAllAndListsTheFirst) {
  const Mesh a(shapes::tangle(120));
  const Mesh b(shapes::translated(shapes::tangle(90), {0.1, 0.2, 0.05}));
  const Pairs all = find_intersections(a.cut, a.tree, b.cut, b.tree);
  ContactCounts counts;
  counts.add(all);
  ASSERT_GT(all.size(), 1000U);
  for (const std::size_t n_threads : {1, 2, 5}) {
    const ThreadLimit limit(n_threads);
    for (const std::size_t max_listed : {0, 1, 50, 1000}) {
      const FoundPairs found = count_intersections(a.cut, a.tree, b.cut, b.tree,
                                                   {.max_listed = max_listed, .wants_to_stop = {}});
      EXPECT_EQ(found.listed, Pairs(all.begin(), all.begin() + static_cast<int>(max_listed)));
      EXPECT_EQ(found.counts, counts);
      EXPECT_TRUE(found.is_complete);
    }
  }
}

TEST(CountIntersections, EndsWhenItIsToldToStop) {
  const Mesh a(shapes::tangle(400));
  const Mesh b(shapes::translated(shapes::tangle(300), {0.1, 0.2, 0.05}));
  const FoundPairs found =
      count_intersections(a.cut, a.tree, b.cut, b.tree, {.wants_to_stop = [] { return true; }});
  EXPECT_FALSE(found.is_complete);
  EXPECT_LT(found.counts.total(), find_intersections(a.cut, a.tree, b.cut, b.tree).size());
}

}  // namespace
}  // namespace meshalyzer
