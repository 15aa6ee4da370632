#include "meshalyzer/spatial/closest_point.h"

#include "meshalyzer/mesh/build.h"
#include "support/constants.h"
#include "support/effort.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

/// A mesh and all that answers questions about it.
struct Scene {
  explicit Scene(const Soup& soup) : cut(build(soup)) {}
  CutMesh cut;
  FaceTree tree{cut};
  ClosestPoints closest{tree};

  /// The answer by asking every face.
  [[nodiscard]] std::optional<SurfacePoint> by_brute_force(const ClosestQuery& query) const {
    std::optional<SurfacePoint> best;
    for (Index slot = 0; slot < tree.n_faces(); ++slot) {
      const Triangle& t = tree.triangle(slot);
      const Corners corners{tree.point(t[0]), tree.point(t[1]), tree.point(t[2])};
      const Index face = tree.mesh_face(slot);
      const auto found = query.cone ? closest_on_triangle(corners, query.point, *query.cone)
                                    : closest_on_triangle(corners, query.point);
      if (!found || found->distance > query.within ||
          (!query.excluded.empty() && query.excluded[face] != 0)) {
        continue;
      }
      if (!best || found->distance < best->distance ||
          (found->distance == best->distance && face < best->mesh_face)) {
        best = SurfacePoint{found->point, found->distance, face, slot};
      }
    }
    return best;
  }
};

/// The two answers have the same bits.
void expect_same(const std::optional<SurfacePoint>& a, const std::optional<SurfacePoint>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (a) {
    EXPECT_EQ(a->distance, b->distance);
    EXPECT_EQ(a->point, b->point);
    EXPECT_EQ(a->mesh_face, b->mesh_face);
    EXPECT_EQ(a->slot, b->slot);
  }
}

class RandomVectors {
 public:
  double real() { return real_(engine_); }
  Vec3 vector() { return {real(), real(), real()}; }
  Index below(Index n) { return meshalyzer::below(engine_, n); }
  std::mt19937& engine() { return engine_; }

 private:
  std::mt19937 engine_{5};
  std::uniform_real_distribution<> real_{-1.0, 1.0};
};

/// Triangles of all sizes and shapes, some of zero area.
Soup random_triangles(std::size_t n, RandomVectors& random) {
  Soup soup;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 corner = random.vector();
    const double size = std::pow(10.0, 3 * random.real() - 3);
    const Vec3 along = size * random.vector();
    const double thin = i % 3 == 0 ? 1e-6 : 1.0;
    const Vec3 across = i % 10 == 0 ? Vec3(along / 2) : Vec3(thin * size * random.vector());
    const auto first = static_cast<Index>(soup.n_vertices());
    soup.positions.insert(soup.positions.end(), {corner, corner + along, corner + across});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// A torus of which two vertices are far away, as a wrong exponent puts them.
Soup torus_with_far_vertices() {
  Soup soup = shapes::torus(2, 0.5, 30, 30);
  soup.positions[7] = {1e28, 0, 3};
  soup.positions[400] = {1, -2e5, 4e4};
  return soup;
}

/// Triangles of all sizes, as random bits give them: next to the largest all others are a point in
/// single precision.
Soup triangles_of_all_sizes(std::size_t n, RandomVectors& random) {
  Soup soup;
  for (std::size_t i = 0; i < n; ++i) {
    const double size = std::pow(10.0, 39.0 * random.real());
    const Vec3 corner = size * random.vector();
    const auto first = static_cast<Index>(soup.n_vertices());
    for (std::size_t k = 0; k < 3; ++k) {
      soup.positions.push_back(corner + 0.2 * size * random.vector());
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

std::vector<Soup> soups(RandomVectors& random) {
  return {shapes::icosphere(3),
          shapes::grid(15, 9),
          shapes::cube(),
          shapes::tetrahedron(),
          shapes::pillow(),
          shapes::translated(shapes::torus(2, 0.5, 40, 20), {1e6, -1e3, 7}),
          damaged(shapes::torus(2, 0.5, 30, 30), 10, random.engine()),
          torus_with_far_vertices(),
          triangles_of_all_sizes(300, random),
          random_triangles(700, random)};
}

/// Near a mesh, at its vertices, and far away.
Vec3 query_point(const Scene& scene, RandomVectors& random) {
  const Vec3 middle = scene.tree.bounds().center();
  const double size = scene.tree.bounds().diagonal().norm();
  const Vec3& vertex =
      scene.tree.point(random.below(static_cast<Index>(scene.cut.side.n_file_vertices)));
  switch (random.below(5)) {
    case 0:
      return vertex;
    case 1:
      return vertex + 0.02 * size * random.vector();
    case 2:
      return middle + size * random.vector();
    case 3:
      return middle;
    default:
      return middle + std::pow(10.0, 8 * random.real() + 8) * size * random.vector();
  }
}

TEST(ClosestPoints, AgreeWithBruteForceToTheBit) {
  RandomVectors random;
  for (const Soup& soup : soups(random)) {
    const Scene scene(soup);
    for (std::size_t i = 0; i < 400; i += test::one_of()) {
      const ClosestQuery query{.point = query_point(scene, random)};
      expect_same(scene.closest.find(query), scene.by_brute_force(query));
    }
  }
}

TEST(ClosestPoints, LimitConeAndExclusionAgreeWithBruteForceToTheBit) {
  RandomVectors random;
  int n_found = 0;
  int n_missed = 0;
  for (const Soup& soup : soups(random)) {
    const Scene scene(soup);
    std::vector<std::uint8_t> excluded(scene.tree.n_faces());
    for (int i = 0; i < 600; ++i) {
      for (std::uint8_t& entry : excluded) {
        entry = random.below(3) == 0 ? 1 : 0;
      }
      ClosestQuery query{.point = query_point(scene, random)};
      if (i % 2 == 0) query.within = std::abs(random.real());
      if (i % 3 != 0) query.cone = Cone{random.vector().normalized(), std::abs(random.real())};
      if (i % 5 == 0) query.excluded = excluded;
      if (i % 7 != 0) query.hint = random.below(static_cast<Index>(scene.tree.n_faces()));
      const auto found = scene.closest.find(query);
      expect_same(found, scene.by_brute_force(query));
      ++(found ? n_found : n_missed);
    }
  }
  EXPECT_GT(n_found, 1000);
  EXPECT_GT(n_missed, 1000);
}

TEST(ClosestPoints, PointsOnFacesThatReachFarAgreeWithBruteForceToTheBit) {
  const Scene scene(torus_with_far_vertices());
  ASSERT_TRUE(scene.tree.has_far_faces());
  std::size_t n_far = 0;
  for (std::size_t slot = 0; slot < scene.tree.n_faces(); ++slot) {
    Triangle t = scene.tree.triangle(slot);
    const auto far = std::find_if(t.begin(), t.end(), [](Index v) { return v == 7 || v == 400; });
    if (far == t.end()) continue;
    ++n_far;
    std::rotate(t.begin(), far, t.end());
    const Vec3 side = scene.tree.point(t[0]) - scene.tree.point(t[1]);
    for (const double away : {0.5, 2.0, 7.0, 30.0, 1000.0}) {
      const ClosestQuery query{.point = scene.tree.point(t[1]) + away / side.norm() * side};
      expect_same(scene.closest.find(query), scene.by_brute_force(query));
    }
  }
  EXPECT_EQ(n_far, 12U);
}

TEST(ClosestPoints, MeshesOfAnySizeAgreeWithBruteForceToTheBit) {
  RandomVectors random;
  for (const double size : {1e-320, 1e-300, 1e-160, 1e160, 1e300, 1.7e308}) {
    const Scene scene(shapes::scaled(shapes::icosphere(2), size));
    for (const double far : {0.0, 0.1, 1.0, 1e3, 1e30, 1e300}) {
      for (int i = 0; i < 20; ++i) {
        const Vec3 p = (std::min(far * size, 1.7e308) * random.vector()).eval();
        const Cone cone{random.vector().normalized(), std::abs(random.real())};
        for (const ClosestQuery& query :
             {ClosestQuery{.point = p}, ClosestQuery{.point = p, .cone = cone}}) {
          const auto found = scene.closest.find(query);
          expect_same(found, scene.by_brute_force(query));
          EXPECT_TRUE(found || query.cone);
          EXPECT_FALSE(found && (found->point.hasNaN() || std::isnan(found->distance)));
        }
      }
    }
  }
}

TEST(ClosestPoints, HintDoesNotChangeTheAnswer) {
  RandomVectors random;
  const Scene scene(random_triangles(200, random));
  for (int i = 0; i < 20; ++i) {
    const ClosestQuery query{.point = random.vector(), .within = 0.3};
    const auto without = scene.closest.find(query);
    for (Index hint = 0; hint < scene.tree.n_faces(); ++hint) {
      ClosestQuery hinted = query;
      hinted.hint = hint;
      expect_same(scene.closest.find(hinted), without);
    }
  }
}

TEST(ClosestPoints, UnwantedFacesAreLikeExcludedOnes) {
  RandomVectors random;
  const Scene scene(random_triangles(300, random));
  for (int i = 0; i < 300; ++i) {
    std::vector<std::uint8_t> excluded(scene.tree.n_faces());
    for (std::uint8_t& entry : excluded) entry = random.below(3) == 0 ? 1 : 0;
    const std::function<bool(Index)> is_wanted = [&](Index face) { return excluded[face] == 0; };
    ClosestQuery query{.point = query_point(scene, random), .is_wanted = &is_wanted};
    const auto found = scene.closest.find(query);
    query.is_wanted = nullptr;
    query.excluded = excluded;
    expect_same(found, scene.by_brute_force(query));
  }
}

/// One triangle, as often as asked for, each time with its own vertices.
Soup heap_of_triangles(std::size_t n) {
  Soup soup;
  for (std::size_t i = 0; i < n; ++i) {
    const auto first = static_cast<Index>(soup.n_vertices());
    soup.positions.insert(soup.positions.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TEST(ClosestPoints, SearchForAnyFaceAtThePointEndsAtTheFirst) {
  const Scene scene(heap_of_triangles(1000));
  std::size_t n_examined = 0;
  const std::function<bool(Index)> is_wanted = [&](Index) { return ++n_examined > 0; };
  const ClosestQuery first{.point = {0.25, 0.25, 0.0}, .is_wanted = &is_wanted};
  EXPECT_EQ(scene.closest.find(first)->mesh_face, 0U);
  EXPECT_EQ(n_examined, 1000U);
  n_examined = 0;
  ClosestQuery any = first;
  any.near_enough = 0.0;
  EXPECT_EQ(scene.closest.find(any)->distance, 0.0);
  EXPECT_EQ(n_examined, 1U);
}

TEST(ClosestPoints, AnyFaceAtThePointIsTheClosestElsewhere) {
  RandomVectors random;
  for (const Soup& soup : soups(random)) {
    const Scene scene(soup);
    for (int i = 0; i < 100; ++i) {
      ClosestQuery query{.point = query_point(scene, random),
                         .within = i % 3 == 0 ? 0.0 : 1e300,
                         .near_enough = 0.0};
      const auto found = scene.closest.find(query);
      const auto closest = scene.by_brute_force(query);
      ASSERT_EQ(found.has_value(), closest.has_value());
      if (!found) continue;
      EXPECT_EQ(found->distance, closest->distance);
      if (found->distance > 0.0) expect_same(found, closest);
    }
  }
}

TEST(ClosestPoints, AnyFaceNearEnoughIsOneOfThoseAndElsewhereTheClosest) {
  RandomVectors random;
  for (const Soup& soup : soups(random)) {
    const Scene scene(soup);
    for (int i = 0; i < 100; ++i) {
      ClosestQuery query{.point = query_point(scene, random)};
      const auto closest = scene.by_brute_force(query);
      if (!closest) continue;
      // So near that only the closest will do, and so far that others may.
      for (const double share : {0.5, 1.0, 2.0}) {
        query.near_enough = share * closest->distance;
        const auto found = scene.closest.find(query);
        ASSERT_TRUE(found);
        if (share < 1.0 && closest->distance > 0.0) {
          expect_same(found, closest);
        } else {
          EXPECT_LE(found->distance, *query.near_enough);
        }
      }
    }
  }
}

TEST(ClosestPoints, SearchForAFaceNearEnoughEndsAtTheFirst) {
  const Scene scene(heap_of_triangles(1000));
  std::size_t n_examined = 0;
  const std::function<bool(Index)> is_wanted = [&](Index) { return ++n_examined > 0; };
  ClosestQuery query{.point = {0.25, 0.25, 0.5}, .is_wanted = &is_wanted, .near_enough = 0.5};
  EXPECT_EQ(scene.closest.find(query)->distance, 0.5);
  EXPECT_EQ(n_examined, 1U);
  query.near_enough = 0.25;
  EXPECT_EQ(scene.closest.find(query)->mesh_face, 0U);
  EXPECT_GT(n_examined, 1000U);
}

TEST(ClosestPoints, AnyNumberOfFacesAgreesWithBruteForce) {
  RandomVectors random;
  for (std::size_t n = 1; n <= 70; ++n) {
    const Scene scene(random_triangles(n, random));
    for (int i = 0; i < 20; ++i) {
      const ClosestQuery query{.point = random.vector()};
      const auto found = scene.closest.find(query);
      ASSERT_TRUE(found);
      expect_same(found, scene.by_brute_force(query));
    }
  }
}

TEST(ClosestPoints, NoFacesHaveNone) {
  EXPECT_FALSE(Scene(Soup{}).closest.find({.point = Vec3::Zero()}));
  EXPECT_FALSE(Scene(Soup{}).closest.find({.point = Vec3::Zero(), .hint = 0}));
}

TEST(ClosestPoints, FacesAtOnePointAreThatPoint) {
  const Vec3 here(1e10, 3, -7);
  const Scene scene(shapes::make({here, here, here}, {{0, 1, 2}}));
  const auto found = scene.closest.find({.point = here + Vec3(0, 4, 3)});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->distance, 5.0);
  EXPECT_EQ(found->point, here);
}

TEST(ClosestPoints, LimitIsInclusive) {
  const Scene scene(shapes::cube());
  const Vec3 above(0.5, 0.25, 3);
  EXPECT_TRUE(scene.closest.find({.point = above, .within = 2.0}));
  EXPECT_FALSE(scene.closest.find({.point = above, .within = std::nextafter(2.0, 0.0)}));
  EXPECT_TRUE(scene.closest.find({.point = Vec3(1, 1, 1), .within = 0.0}));
  EXPECT_FALSE(scene.closest.find({.point = Vec3(1, 1, 1), .within = -1.0}));
}

TEST(ClosestPoints, FirstOfEquallyNearFacesIsTold) {
  // Eight faces meet at the middle of this grid of four squares; the answer is the first of them
  // whatever the order.
  const Soup grid = shapes::grid(2, 2);
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Soup shuffled = shapes::shuffled_faces(grid, seed);
    Index first = kNoIndex;
    for (Index f = 0; f < shuffled.n_faces(); ++f) {
      const Triangle& t = shuffled.triangles[f];
      const auto at_middle = [&](Index v) { return shuffled.positions[v] == Vec3(1, 1, 0); };
      if (first == kNoIndex && (at_middle(t[0]) || at_middle(t[1]) || at_middle(t[2]))) first = f;
    }
    const auto found = Scene(shuffled).closest.find({.point = Vec3(1, 1, 0)});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->mesh_face, first);
    EXPECT_EQ(found->distance, 0.0);
  }
}

TEST(ClosestPoints, ExcludedFacesAreLeftOut) {
  // Without the two faces of the top (z = 1), the middle of the top is nearest to the four sides.
  const Soup cube = shapes::cube();
  const Scene scene(cube);
  std::vector<std::uint8_t> excluded;
  for (const Triangle& t : cube.triangles) {
    excluded.push_back(
        cube.positions[t[0]].z() + cube.positions[t[1]].z() + cube.positions[t[2]].z() == 3 ? 1
                                                                                            : 0);
  }
  const Vec3 p(0.5, 0.4, 1);
  EXPECT_EQ(scene.closest.find({.point = p})->distance, 0.0);
  const auto found = scene.closest.find({.point = p, .excluded = excluded});
  EXPECT_EQ(found->point, Vec3(0.5, 0, 1));
  EXPECT_EQ(found->distance, 0.4);
  excluded.assign(excluded.size(), 1);
  EXPECT_FALSE(scene.closest.find({.point = p, .excluded = excluded}));
}

TEST(ClosestPoints, SphereIsSeenAtItsRadius) {
  // Inside: at least the inscribed radius; outside: the distance of a point of the sphere's hull.
  const Scene scene(shapes::icosphere(4));
  RandomVectors random;
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = 3 * random.vector();
    const double distance = scene.closest.find({.point = p})->distance;
    EXPECT_NEAR(distance, std::abs(p.norm() - 1.0), 0.005);
  }
}

TEST(ClosestPoints, NothingIsWithinADistanceOfABoxThatTheMeshIsNotNear) {
  RandomVectors random;
  int n_not_near = 0;
  for (const Soup& soup : soups(random)) {
    const Scene scene(soup);
    const double size = scene.tree.bounds().diagonal().norm();
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = query_point(scene, random);
      Box3 box(p);
      box.extend((p + 0.1 * size * random.vector()).eval());
      // As near as the mesh is to p, or a little nearer.
      const double nearest = scene.by_brute_force({.point = p})->distance;
      EXPECT_TRUE(scene.closest.may_be_within(box, nearest));
      const bool is_near = scene.closest.may_be_within(box, 0.5 * nearest);
      n_not_near += is_near ? 0 : 1;
      const Vec3 other = box.center();
      EXPECT_TRUE(is_near || !scene.by_brute_force({.point = other, .within = 0.5 * nearest}));
    }
  }
  EXPECT_GT(n_not_near, 500);
}

TEST(ClosestPoints, BoxIsAsFarFromASphereAsItsCornerIs) {
  // The corner (3, 3, 3) is sqrt(27) - 1 = 4.196 from the unit sphere; boxes of leaves reach out of
  // it a little.
  const Scene scene(shapes::icosphere(4));
  const Box3 box(Vec3(3, 3, 3), Vec3(4, 5, 6));
  EXPECT_FALSE(scene.closest.may_be_within(box, 4.0));
  EXPECT_TRUE(scene.closest.may_be_within(box, 4.2));
  EXPECT_TRUE(scene.closest.may_be_within(box, kInfinity));
  EXPECT_TRUE(scene.closest.may_be_within(Box3(Vec3(0.9, -9, -9), Vec3(9, 9, 9)), 0.0));
  EXPECT_FALSE(scene.closest.may_be_within(Box3(Vec3(1.1, -9, -9), Vec3(9, 9, 9)), 0.0));
}

TEST(ClosestPoints, DistanceBeyondTheLargestNumberIsInfinite) {
  const Scene scene(shapes::scaled(shapes::cube(), 1e308));
  const auto found = scene.closest.find({.point = Vec3::Constant(-1.7e308)});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->distance, kInfinity);
}

TEST(ClosestPoints, PointThatIsNotFiniteHasNone) {
  const CutMesh cut = build(shapes::icosphere(2));
  const FaceTree tree(cut);
  const ClosestPoints closest(tree);
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(closest.find({.point = Vec3(0, wrong, 0)})) << wrong;
    EXPECT_FALSE(closest.find({.point = Vec3::Constant(wrong)})) << wrong;
  }
}

}  // namespace
}  // namespace meshalyzer
