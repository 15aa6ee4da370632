#include "meshalyzer/set/measure_separation.h"

#include "direct_evaluation.h"
#include "meshalyzer/base/parallel.h"
#include "object_scene.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using test::ObjectScene;

/// Every vertex, number and point with the same bits.
void expect_same(const ObjectSeparation& a, const ObjectSeparation& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.objects, b.objects);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.points, b.points);
  ASSERT_EQ(a.distances.size(), b.distances.size());
  for (std::size_t i = 0; i < a.distances.size(); ++i) {
    EXPECT_TRUE(std::bit_cast<std::uint64_t>(a.distances[i]) ==
                    std::bit_cast<std::uint64_t>(b.distances[i]) ||
                (std::isnan(a.distances[i]) && std::isnan(b.distances[i])))
        << a.vertices[i] << ": " << a.distances[i] << " and " << b.distances[i];
  }
}

/// Counts of each case, so that a test can make sure that it occurred.
struct Seen {
  std::size_t inside = 0;
  std::size_t touching = 0;
  std::size_t outside = 0;
  std::size_t nothing = 0;
  std::size_t itself = 0;

  void add(Index object, const ObjectSeparation& separation) {
    for (std::size_t i = 0; i < separation.distances.size(); ++i) {
      const double distance = separation.distances[i];
      ++(std::isnan(distance) ? nothing
         : distance < 0       ? inside
         : distance == 0      ? touching
                              : outside);
      itself += separation.objects[i] == object ? 1 : 0;
    }
  }
};

void expect_direct(const std::vector<Soup>& soups, const SeparationOptions& options, Seen& seen) {
  ObjectScene scene(soups);
  for (Index object = 0; object < soups.size(); ++object) {
    SCOPED_TRACE("object " + std::to_string(object));
    const ObjectSeparation separation = scene.measure(object, options);
    expect_same(separation, test::direct_separation(soups, object, options));
    seen.add(object, separation);
  }
}

using Random = std::mt19937;

Soup random_shape(Random& random) {
  switch (below(random, 8)) {
    case 0:
      return shapes::tetrahedron();
    case 1:
      return shapes::icosphere(0);
    case 2:
      return shapes::torus(1, 0.5, 6, 4);
    case 3:
      return shapes::scaled(shapes::nested_cubes(shapes::InnerShell::Cavity), 0.75);
    case 4:
      return shapes::open_cube();
    case 5:
      return shapes::merged(shapes::grid(2, 1), shapes::translated(shapes::cube(), {0, 0, 1}));
    default:
      return shapes::cube();
  }
}

/// On a lattice much touches and overlaps; elsewhere it crosses, or is apart.
enum class Places { OnLattice, Anywhere };

std::vector<Soup> random_set(Places places, double spread, Random& random) {
  std::vector<Soup> soups;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto coordinate = [&] {
      const double at = static_cast<double>(below(random, 9)) / 4;
      return spread * (places == Places::OnLattice ? at : at + 1e-9 * below(random, 1'000'000'000));
    };
    const double x = coordinate();
    const double y = coordinate();
    const double size = std::ldexp(1.0, static_cast<int>(below(random, 3)) - 1);
    soups.push_back(
        shapes::translated(shapes::scaled(random_shape(random), size), {x, y, coordinate()}));
  }
  return soups;
}

void expect_direct_on_random_sets(const SeparationOptions& options, Seen& seen) {
  Random random(20);
  for (int round = 0; round < 6; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    expect_direct(random_set(Places::OnLattice, 1.0, random), options, seen);
    expect_direct(random_set(Places::Anywhere, 1.0, random), options, seen);
    expect_direct(random_set(Places::Anywhere, 20.0, random), options, seen);
  }
}

TEST(MeasureSeparation, EqualsAskingEveryFaceToTheBit) {
  Seen seen;
  expect_direct_on_random_sets({}, seen);
  EXPECT_GT(seen.inside, 30U);
  EXPECT_GT(seen.touching, 10U);
  EXPECT_GT(seen.outside, 500U);
  EXPECT_EQ(seen.nothing, 0U);
  EXPECT_EQ(seen.itself, 0U);
}

TEST(MeasureSeparation, RadiusEqualsAskingEveryFaceToTheBit) {
  Seen seen;
  expect_direct_on_random_sets({.search_radius = 0.5}, seen);
  EXPECT_GT(seen.inside, 30U);
  EXPECT_GT(seen.touching, 10U);
  EXPECT_GT(seen.outside, 50U);
  EXPECT_GT(seen.nothing, 500U);
}

TEST(MeasureSeparation, ConeEqualsAskingEveryFaceToTheBit) {
  for (const double degrees : {10.0, 60.0, 90.0}) {
    SCOPED_TRACE(degrees);
    Seen seen;
    expect_direct_on_random_sets({.search_cone_degrees = degrees}, seen);
    EXPECT_GT(seen.outside, 100U);
    EXPECT_GT(seen.nothing, 100U);
  }
}

TEST(MeasureSeparation, OwnSurfaceEqualsAskingEveryFaceToTheBit) {
  Seen seen;
  expect_direct_on_random_sets({.include_self = 0.3123}, seen);
  EXPECT_GT(seen.itself, 100U);
  EXPECT_GT(seen.inside, 30U);
  EXPECT_GT(seen.outside, 100U);
}

TEST(MeasureSeparation, AllOptionsTogetherEqualAskingEveryFaceToTheBit) {
  Seen seen;
  expect_direct_on_random_sets(
      {.search_radius = 1.0, .search_cone_degrees = 75.0, .include_self = 0.7071}, seen);
  EXPECT_GT(seen.itself, 20U);
  EXPECT_GT(seen.nothing, 100U);
  EXPECT_GT(seen.outside, 100U);
}

TEST(MeasureSeparation, LargeFacesAsFarButForRoundingEqualAskingEveryFaceToTheBit) {
  // Faces of a million across nearly level, some 1e-11 apart about 1 above and 1 below a vertex: by
  // the rounding of their computed distances they may be nearer than their boxes.
  Random random(4);
  std::uniform_real_distribution<> real(-1.0, 1.0);
  for (int round = 0; round < 60; ++round) {
    std::vector<Soup> soups{shapes::make({{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}}, {{0, 1, 2}})};
    for (const double side : {1.0, -1.0, 1.0, -1.0}) {
      const double height = 1 + 2e-11 * real(random);
      const auto corner = [&](double x, double y) {
        return Vec3(1e6 * (x + 0.3 * real(random)), 1e6 * (y + 0.3 * real(random)),
                    side * (height + 1e-13 * real(random)));
      };
      soups.push_back(shapes::make({corner(-1, -1), corner(1, -1), corner(0, 1)}, {{0, 1, 2}}));
    }
    Seen seen;
    SCOPED_TRACE("round " + std::to_string(round));
    expect_direct(soups, {}, seen);
  }
}

TEST(MeasureSeparation, SmallestAndLargestNumbersEqualAskingEveryFaceToTheBit) {
  // Down to where a cube is a few of the smallest numbers wide.
  for (const double size : {1e300, 1e-300, 1e-310, 8 * std::numeric_limits<double>::denorm_min()}) {
    SCOPED_TRACE(size);
    Random random(6);
    Seen seen;
    for (int round = 0; round < 6; ++round) {
      std::vector<Soup> soups = random_set(Places::OnLattice, 2.0, random);
      for (Soup& soup : soups) {
        soup = shapes::scaled(soup, size);
      }
      expect_direct(soups, {}, seen);
    }
    EXPECT_GT(seen.outside, 100U);
  }
}

TEST(MeasureSeparation, EqualDistancesGoToTheFirstObjectAndItsFirstFace) {
  // The middle cube is 1 from either neighbour, whose sides are two faces each.
  std::vector<Soup> soups{shapes::cube(1.0, {2, 0, 0}), shapes::cube(1.0, {-2, 0, 0}),
                          shapes::cube()};
  for (Soup& soup : soups) {
    soup.face_ids.first = 100;
  }
  const ObjectSeparation separation = ObjectScene(soups).measure(2);
  expect_same(separation, test::direct_separation(soups, 2));
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(separation.distances[i], 1.0);
    EXPECT_EQ(separation.objects[i], soups[2].positions[i].x() == 1.0 ? 0U : 1U);
    EXPECT_GE(separation.faces[i], 100);
  }
  // Between two that are the same, it is the first.
  soups[1] = soups[0];
  const std::vector<Index> first(8, 0);
  EXPECT_EQ(ObjectScene(soups).measure(2).objects, first);
}

TEST(MeasureSeparation, OnlyVerticesThatFacesUseAreMeasuredAndByTheirIds) {
  Soup soup = shapes::tetrahedron();
  soup.positions.insert(soup.positions.begin(), Vec3(0, 0, 5));
  soup.triangles = {{1, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}, {0, 0, 1}};
  soup.vertex_ids.named = {50, 40, 30, 20, 10};
  ObjectScene scene({soup, shapes::translated(shapes::cube(), {0, 0, 7})});
  EXPECT_EQ(scene.measure(0).vertices, (std::vector<std::int64_t>{40, 30, 20, 10}));
  // From the cube's floor the tip at (0, 0, 1) is the nearest; the orphan at 5 does not count.
  EXPECT_EQ(scene.measure(1).distances.at(0), 6.0);
}

TEST(MeasureSeparation, AloneInItsSetThereIsNothingToFind) {
  // Boxes of objects to be left out are empty.
  for (const auto& soups :
       {std::vector<Soup>{shapes::cube()},
        std::vector<Soup>{shapes::cube(), Soup(), shapes::make({{1, 2, 3}}, {})}}) {
    const ObjectSeparation separation = ObjectScene(soups).measure(0);
    EXPECT_EQ(separation.objects, std::vector<Index>(8, kNoIndex));
    for (const double distance : separation.distances) {
      EXPECT_TRUE(std::isnan(distance));
    }
  }
}

TEST(MeasureSeparation, RadiusHoldsWhatIsJustAsFar) {
  const std::vector<Soup> soups{shapes::cube(), shapes::translated(shapes::cube(), {3, 0, 0})};
  const auto n_found = [&](double radius) {
    const ObjectSeparation found = ObjectScene(soups).measure(0, {.search_radius = radius});
    return std::count(found.objects.begin(), found.objects.end(), 1U);
  };
  EXPECT_EQ(n_found(3.0), 8);
  EXPECT_EQ(n_found(std::nextafter(3.0, 2.0)), 4);
  EXPECT_EQ(n_found(2.0), 4);
  EXPECT_EQ(n_found(std::nextafter(2.0, 1.0)), 0);
}

TEST(MeasureSeparation, VertexInsideIsNegativeAlsoToItsOwnSurface) {
  // Within the large cube, 100 from its sides, the small one is nearest to itself.
  ObjectScene scene({shapes::cube(1.0, {100, 100, 100}), shapes::cube(201.0)});
  const ObjectSeparation separation = scene.measure(0, {.include_self = 0.0});
  for (std::size_t i = 0; i < 8; ++i) {
    // sqrt(1/2): from a corner of the square to the diagonal that does not end there; at most, for
    // the faces at the other corners.
    EXPECT_EQ(separation.objects[i], 0U);
    EXPECT_LE(separation.distances[i], -std::sqrt(0.5) + 1e-15);
    EXPECT_GE(separation.distances[i], -1.0);
  }
}

TEST(MeasureSeparation, ComponentsInsideDifferentObjectsAreAllInside) {
  ObjectScene scene({shapes::merged(shapes::cube(1.0, {1, 1, 1}), shapes::cube(1.0, {11, 1, 1})),
                     shapes::cube(3.0), shapes::cube(3.0, {10, 0, 0})});
  EXPECT_EQ(scene.measure(0).distances, std::vector<double>(16, -1.0));
}

TEST(MeasureSeparation, VertexWithoutNormalHasNothingInItsCone) {
  // The corners of the second face are in line; the grid is above them all.
  const Soup soup = shapes::make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5.25, 5.5, 0}, {6.25, 6.5, 0}, {7.25, 7.5, 0}},
      {{0, 1, 2}, {3, 4, 5}});
  ObjectScene scene({soup, shapes::translated(shapes::grid(9, 9), {0, 0, 2})});
  for (const double degrees : {0.0, 30.0, 90.0}) {
    const ObjectSeparation separation = scene.measure(0, {.search_cone_degrees = degrees});
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_EQ(separation.objects[i], i < 3 ? 1U : kNoIndex);
      EXPECT_EQ(std::isnan(separation.distances[i]), i >= 3);
    }
  }
}

/// Some vertices inside, some not, and more than one chunk of them.
std::vector<Soup> spheres() {
  const Soup sphere = shapes::icosphere(3);
  return {sphere, shapes::translated(sphere, {1.3, 0, 0}), shapes::translated(sphere, {0, 2.6, 0}),
          shapes::scaled(sphere, 0.3)};
}

TEST(MeasureSeparation, SameForAnyNumberOfThreads) {
  const SeparationOptions all{
      .search_radius = 1.5, .search_cone_degrees = 80.0, .include_self = 0.3};
  for (const SeparationOptions& options : {SeparationOptions{}, all}) {
    ObjectScene scene(spheres());
    for (Index object = 0; object < 4; ++object) {
      ObjectSeparation by_one;
      {
        const ThreadLimit one(1);
        by_one = scene.measure(object, options);
      }
      const ThreadLimit many(8);
      expect_same(scene.measure(object, options), by_one);
    }
  }
}

TEST(MeasureSeparation, SameWithoutMemoryToKeepObjects) {
  ObjectScene scene(spheres());
  ObjectScene forgetful(spheres(), 0);
  for (Index object = 0; object < 4; ++object) {
    expect_same(forgetful.measure(object), scene.measure(object));
  }
  EXPECT_EQ(scene.cache().n_loads(), 4U);
  EXPECT_GT(forgetful.cache().n_loads(), 8U);
}

TEST(MeasureSeparation, ObjectsBehindNearerOnesAreNotLoaded) {
  // A row of cubes with gaps of 1: from the first one, the third is 3 away, 2 from behind the
  // second.
  std::vector<Soup> row;
  for (int i = 0; i < 20; ++i) {
    row.push_back(shapes::cube(1.0, {2.0 * i, 0, 0}));
  }
  ObjectScene scene(row);
  (void)scene.measure(0);
  EXPECT_EQ(scene.cache().n_loads(), 2U);
}

TEST(MeasureSeparation, NoMoreThanTwoObjectsAreHeld) {
  ObjectScene forgetful(spheres(), 0);
  (void)forgetful.measure(0);
  // Two held, and one that is forgotten when the next one is there.
  EXPECT_LE(forgetful.cache().peak_bytes(),
            3 * SetObject(shapes::icosphere(3), ClosestUse::Prepared).bytes());
}

}  // namespace
}  // namespace meshalyzer
