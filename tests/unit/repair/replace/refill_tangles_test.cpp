#include "meshalyzer/repair/cut/internal/cut_topology.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/replace/internal/tangles.h"
#include "support/run_pass.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

namespace meshalyzer {
namespace {

/// The vertices of the faces round a vertex, without it.
std::vector<Index> neighbours(const Soup& soup, Index vertex) {
  std::vector<Index> found;
  for (const Triangle& t : soup.triangles) {
    if (std::find(t.begin(), t.end(), vertex) == t.end()) continue;
    for (const Index v : t) {
      if (v != vertex && std::find(found.begin(), found.end(), v) == found.end()) {
        found.push_back(v);
      }
    }
  }
  return found;
}

/// Shrinks the faces round a vertex and turns them by half a turn: the faces beside them cross each
/// other near the vertex.
void tangle(Soup& soup, Index vertex, double share) {
  const Vec3 middle = soup.positions[vertex];
  for (const Index v : neighbours(soup, vertex)) {
    soup.positions[v] = middle - share * (soup.positions[v] - middle);
  }
}

/// Returns the vertex opposite another one of a sphere about the origin.
Index opposite(const Soup& sphere, Index vertex) {
  const Vec3 to = -sphere.positions[vertex];
  const auto found = std::min_element(
      sphere.positions.begin(), sphere.positions.end(),
      [&](const Vec3& a, const Vec3& b) { return (a - to).norm() < (b - to).norm(); });
  return static_cast<Index>(found - sphere.positions.begin());
}

/// A sphere of radius 1 with a tangle.
Soup sphere_with_tangle(Index vertex, double share) {
  Soup soup = shapes::icosphere(3);
  tangle(soup, vertex, share);
  return soup;
}

/// #V - #E + #F of a closed mesh, in which each face has three halves of edges.
std::ptrdiff_t euler_characteristic(const Soup& soup) {
  std::vector<std::uint8_t> is_used(soup.n_vertices(), 0);
  for (const Triangle& t : soup.triangles) {
    for (const Index v : t) is_used[v] = 1;
  }
  return std::count(is_used.begin(), is_used.end(), 1) -
         static_cast<std::ptrdiff_t>(soup.n_faces() / 2);
}

const LogStep* step_of(const RepairResult& result, std::string_view pass) {
  const auto& steps = result.log.steps;
  const auto found =
      std::find_if(steps.begin(), steps.end(), [&](const LogStep& s) { return s.pass == pass; });
  return found == steps.end() ? nullptr : &*found;
}

TEST(RefillTangles, ATangleSmallerThanTheDeviationBecomesADisc) {
  const Soup tangled = sphere_with_tangle(300, 0.05);
  ASSERT_FALSE(PreparedMesh(tangled).intersecting_pairs().empty());
  RepairOptions options;
  options.max_deviation.value = 0.01;
  const RepairResult result = fix_defects(tangled, options);
  const Soup& made = only_mesh(result);
  EXPECT_TRUE(is_good(made));
  EXPECT_EQ(euler_characteristic(made), 2);
  EXPECT_LT(made.n_faces(), tangled.n_faces());
  ASSERT_NE(step_of(result, "refill tangles"), nullptr);
  EXPECT_EQ(step_of(result, "cut intersections"), nullptr);
  EXPECT_LE(result.deviation, result.max_deviation);
  EXPECT_NEAR(volume_of(made), 4.0 / 3.0 * std::numbers::pi, 0.05);
  // The faces that have no part in the tangle stay, bit for bit.
  EXPECT_GT(made.n_faces(), tangled.n_faces() - 64);
}

TEST(RefillTangles, ALargerTangleIsCut) {
  const Soup tangled = sphere_with_tangle(300, 0.05);
  RepairOptions options;
  options.max_deviation.value = 1e-6;
  const RepairResult result = fix_defects(tangled, options);
  EXPECT_TRUE(is_good(only_mesh(result)));
  EXPECT_EQ(step_of(result, "refill tangles"), nullptr);
  ASSERT_NE(step_of(result, "cut intersections"), nullptr);
  // Cutting keeps the surface where it is, with all that the tangle encloses.
  EXPECT_NE(euler_characteristic(only_mesh(result)), 2);
}

PassResult cut_all(const PassInput& input) {
  return cut_intersections(input, {});
}

TEST(RefillTangles, SolidsThatCrossAreLeft) {
  const Soup cubes = shapes::merged(shapes::cube(), shapes::cube(1.0, {0.001, 0.001, 0.001}));
  const PassRun run =
      run_pass(cubes, [](const PassInput& input) { return refill_tangles(input, cut_all); });
  EXPECT_EQ(run.operations, 0U);
}

/// A sphere, a vertex of which is pulled over its neighbours.
Soup sphere_with_pulled_vertex(Index vertex, double share) {
  Soup soup = shapes::icosphere(3);
  const Vec3 along = soup.positions[neighbours(soup, vertex).front()] - soup.positions[vertex];
  soup.positions[vertex] += share * along;
  return soup;
}

TEST(RefillTangles, WhatCuttingMendsWithoutChangeOfTopologyIsLeftToIt) {
  std::vector<Soup> soups;
  for (const double share : {1.2, 1.5, 2.0, 2.5}) {
    soups.push_back(sphere_with_pulled_vertex(300, share));
  }
  for (const double share : {0.02, 0.1, 0.3}) soups.push_back(sphere_with_tangle(300, share));
  const SurfaceTopology sphere{.euler_characteristic = 2, .components = 1};
  std::size_t n_left = 0;
  std::size_t n_refilled = 0;
  for (const Soup& soup : soups) {
    const PassRun cut = run_pass(soup, cut_all);
    const PassRun refilled =
        run_pass(soup, [](const PassInput& input) { return refill_tangles(input, cut_all); },
                 {.max_deviation = 1.0, .fixed_vertices = {}, .groups = Groups::Names});
    ASSERT_GT(cut.operations, 0U);
    const bool is_left = topology_of(cut.tracked.soup.triangles) == sphere;
    EXPECT_EQ(refilled.operations, is_left ? 0U : 1U);
    EXPECT_TRUE(is_left || topology_of(refilled.tracked.soup.triangles) == sphere);
    ++(is_left ? n_left : n_refilled);
  }
  EXPECT_GT(n_left, 0U);
  EXPECT_GT(n_refilled, 0U);
}

/// Returns the topology of each place that find_tangles() finds.
std::vector<SurfaceTopology> topologies_of_places(const Soup& soup, std::size_t n_rings) {
  std::vector<SurfaceTopology> topologies;
  for (const auto& place : find_tangles(PreparedMesh(soup), {n_rings, 1000}).places) {
    std::vector<Triangle> faces;
    for (const Index face : place) faces.push_back(soup.triangles[face]);
    topologies.push_back(topology_of(faces));
  }
  return topologies;
}

/// A sphere with two tangles that have one vertex in common: they are one place, which is a disc
/// only together with a ring of faces.
Soup sphere_with_two_tangles(Index vertex, double share) {
  const SurfaceTopology disc{.euler_characteristic = 1, .components = 1};
  const SurfaceTopology two_at_a_vertex{.euler_characteristic = 1, .components = 2};
  for (Index other = 0;; ++other) {
    Soup soup = sphere_with_tangle(vertex, share);
    tangle(soup, other, share);
    if (topologies_of_places(soup, 0) == std::vector{two_at_a_vertex} &&
        topologies_of_places(soup, 1) == std::vector{disc}) {
      return soup;
    }
  }
}

TEST(RefillTangles, PlacesWithAndWithoutRingsAreRefilledAfterOneTrialOfTheCut) {
  Soup soup = sphere_with_two_tangles(300, 0.05);
  tangle(soup, opposite(soup, 300), 0.05);
  std::size_t n_cuts = 0;
  const PassFunction cut = [&](const PassInput& input) {
    ++n_cuts;
    return cut_all(input);
  };
  const PassRun run =
      run_pass(soup, [&](const PassInput& input) { return refill_tangles(input, cut); },
               {.max_deviation = 1.0, .fixed_vertices = {}, .groups = Groups::Names});
  EXPECT_EQ(run.operations, 2U);
  EXPECT_EQ(n_cuts, 1U);
  EXPECT_TRUE(is_good(run.tracked.soup));
  EXPECT_EQ(topology_of(run.tracked.soup.triangles),
            (SurfaceTopology{.euler_characteristic = 2, .components = 1}));
}

TEST(FindTangles, TheFacesRoundAreTakenRingByRing) {
  const Soup tangled = sphere_with_tangle(300, 0.05);
  const PreparedMesh mesh(tangled);
  std::size_t n_before = 0;
  for (const std::size_t n_rings : {0U, 1U, 2U}) {
    const Tangles tangles = find_tangles(mesh, {.n_rings = n_rings, .max_faces = 1000});
    ASSERT_EQ(tangles.places.size(), 1U);
    EXPECT_GT(tangles.places[0].size(), n_before);
    n_before = tangles.places[0].size();
    const auto n_left = std::count_if(tangles.rest.triangles.begin(), tangles.rest.triangles.end(),
                                      [](const Triangle& t) { return is_in_complex(t); });
    EXPECT_EQ(static_cast<std::size_t>(n_left) + n_before, tangled.n_faces());
  }
  EXPECT_TRUE(find_tangles(mesh, {.n_rings = 0, .max_faces = 3}).places.empty());
  EXPECT_TRUE(find_tangles(PreparedMesh(shapes::icosphere(1)), {2, 1000}).places.empty());
}

TEST(FindTangles, NothingIsTakenAtAPlaceThatIsRefilled) {
  Soup soup = sphere_with_tangle(300, 0.05);
  tangle(soup, 400, 0.05);
  const PreparedMesh mesh(soup);
  const Tangles both = find_tangles(mesh, {.n_rings = 0, .max_faces = 1000});
  ASSERT_EQ(both.places.size(), 2U);
  const std::vector<Index>& refilled = both.places[0];
  const Tangles left = find_tangles(mesh, {.n_rings = 0, .max_faces = 1000}, refilled);
  ASSERT_EQ(left.places.size(), 1U);
  EXPECT_EQ(left.places[0], both.places[1]);
  EXPECT_EQ(left.rest.triangles, both.rest.triangles);
  // Rings that grow to the refilled place make the other one touch it.
  std::size_t n_rings = 1;
  while (!find_tangles(mesh, {n_rings, 1000}, refilled).places.empty()) ++n_rings;
  EXPECT_GT(n_rings, 2U);
  EXPECT_LT(n_rings, 16U);
}

TEST(FindTangles, WhatATangleCutsOffIsTakenToo) {
  // One ring of vertices is moved through the axis, so that the 32 faces at it intersect each
  // other. Beyond them lies a cap of 8 + 16 faces.
  constexpr Index kSides = 8;
  Soup soup = shapes::uv_sphere(16, kSides);
  for (Index v = 2 * kSides; v < 3 * kSides; ++v) soup.positions[v].head<2>() *= -1.0;
  const Tangles tangles = find_tangles(PreparedMesh(soup), {0, 100});
  ASSERT_EQ(tangles.places.size(), 1U);
  EXPECT_EQ(tangles.places[0].size(), 32U + 24U);
}

TEST(TopologyOf, IsThatOfDiscsSpheresAndHandles) {
  const auto topology = [](const Soup& soup) { return topology_of(soup.triangles); };
  EXPECT_EQ(topology(shapes::grid(3, 2)), (SurfaceTopology{1, 1, true}));
  EXPECT_EQ(topology(shapes::icosphere(1)), (SurfaceTopology{2, 1, true}));
  EXPECT_EQ(topology(shapes::torus(2, 1, 8, 6)), (SurfaceTopology{0, 1, true}));
  EXPECT_EQ(topology(shapes::merged(shapes::cube(), shapes::grid(1, 1))),
            (SurfaceTopology{3, 2, true}));
  EXPECT_EQ(topology(shapes::fan_of_three()), (SurfaceTopology{1, 1, false}));
}

TEST(FacesReplacedAlike, AreThoseOfOperationsThatKeepTheTopology) {
  const Soup soup = shapes::grid(2, 1);
  Edits edits;
  // Both faces of a square are exchanged for the other two of it, those of the other go.
  const Index first = edits.begin_operation();
  const Triangle a = soup.triangles[0];
  const Triangle b = soup.triangles[1];
  const auto opposite = std::find_if(
      b.begin(), b.end(), [&](Index v) { return std::find(a.begin(), a.end(), v) == a.end(); });
  const auto lonely = std::find_if(
      a.begin(), a.end(), [&](Index v) { return std::find(b.begin(), b.end(), v) == b.end(); });
  const auto k = static_cast<std::size_t>(lonely - a.begin());
  edits.removed_faces = {{first, 0}, {first, 1}};
  edits.added_faces = {
      {.op = first, .corners = {*lonely, a[(k + 1) % 3], *opposite}, .prototype = 0},
      {.op = first, .corners = {*lonely, *opposite, a[(k + 2) % 3]}, .prototype = 0}};
  const Index second = edits.begin_operation();
  edits.removed_faces.push_back({second, 2});
  edits.removed_faces.push_back({second, 3});
  EXPECT_EQ(faces_replaced_alike(soup, edits), (std::vector<std::uint8_t>{1, 1, 0, 0}));
}

}  // namespace
}  // namespace meshalyzer
