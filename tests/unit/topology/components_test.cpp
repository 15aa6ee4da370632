#include "meshalyzer/topology/components.h"

#include "direct_evaluation.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace meshalyzer {
namespace {

TEST(FindComponents, EmptyMeshHasNone) {
  const Components components = find_components(build(Soup{}));
  EXPECT_EQ(components.count, 0U);
  EXPECT_TRUE(components.of_face.empty());
}

TEST(FindComponents, OrphanVertexIsNone) {
  Soup soup = shapes::cube();
  soup.positions.emplace_back(9, 9, 9);
  EXPECT_EQ(find_components(build(soup)).count, 1U);
}

TEST(FindComponents, AreNumberedByTheirLowestFace) {
  const Soup soup = shapes::make(std::vector<Vec3>(9, Vec3::Zero()),
                                 {{8, 7, 6}, {0, 1, 2}, {6, 7, 5}, {3, 2, 4}});
  EXPECT_EQ(find_components(build(soup)).of_face, (std::vector<Index>{0, 1, 0, 1}));
  EXPECT_EQ(find_edge_components(build(soup)).of_face, (std::vector<Index>{0, 1, 0, 2}));
}

TEST(FindComponents, TouchingIsEnoughByVertexButNotByEdge) {
  const CutMesh cut = build(shapes::two_tetrahedra_sharing_vertex());
  EXPECT_EQ(find_components(cut).count, 1U);
  EXPECT_EQ(find_edge_components(cut).count, 2U);
}

TEST(FindComponents, TwoLongStripsWhoseFacesAlternateAreTwoForAnyNumberOfThreads) {
  // Face i lies between vertices i, i + 2 and i + 4, so that even and odd faces have no vertex in
  // common, and every other face of a strip is turned.
  constexpr Index n = 40000;
  std::vector<Triangle> faces;
  for (Index i = 0; i < n; ++i) {
    faces.push_back(i % 4 < 2 ? Triangle{i, i + 2, i + 4} : Triangle{i + 2, i, i + 4});
  }
  std::vector<Index> alternating(n);
  for (Index i = 0; i < n; ++i) alternating[i] = i % 2;
  const Soup soup = shapes::make(std::vector<Vec3>(n + 4, Vec3::Zero()), faces);
  for (const std::size_t n_threads : {1U, 4U}) {
    const ThreadLimit limit(n_threads);
    const CutMesh cut = build(soup);
    EXPECT_EQ(find_components(cut).of_face, alternating);
    EXPECT_EQ(find_edge_components(cut).of_face, alternating);
  }
}

TEST(FindComponents, PlacesInSpaceDoNotMatter) {
  EXPECT_EQ(find_components(build(shapes::merged(shapes::cube(), shapes::cube()))).count, 2U);
}

TEST(FindEdgeComponents, CutsDoNotPartThem) {
  EXPECT_EQ(find_edge_components(build(shapes::fan_of_three())).count, 1U);
  EXPECT_EQ(find_edge_components(build(shapes::two_tetrahedra_sharing_edge())).count, 1U);
  EXPECT_EQ(find_edge_components(build(shapes::moebius_strip(4))).count, 1U);
  const std::array<Index, 1> face{3};
  EXPECT_EQ(find_edge_components(build(shapes::flipped(shapes::cube(), face))).count, 1U);
}

TEST(FindOrientedPatches, FlippedFaceIsOneByItself) {
  const std::array<Index, 1> face{3};
  const Components patches = find_oriented_regions(build(shapes::flipped(shapes::cube(), face)));
  std::vector<Index> expected(12, 0);
  expected[3] = 1;
  EXPECT_EQ(patches.of_face, expected);
}

TEST(FindComponents, AgreeWithDirectEvaluationOnRandomSoups) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Soup soup = direct::random_soup(seed, 1 + seed % 12);
    const direct::Complex complex = direct::complex_of(soup);
    const CutMesh cut = build(soup);
    EXPECT_EQ(find_components(cut).of_face, direct::components(complex));
    EXPECT_EQ(find_edge_components(cut).of_face, direct::edge_components(complex));
  }
}

TEST(FindComponents, NumberOfThemIsTheSameInAnyOrder) {
  Soup soup = shapes::merged(shapes::torus(3, 1, 20, 10), shapes::icosphere(2));
  soup = shapes::merged(soup, shapes::klein_bottle(6, 6));
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const Soup other = shapes::renumbered_vertices(shapes::shuffled_faces(soup, seed), seed);
    EXPECT_EQ(find_components(build(other)).count, 3U);
    EXPECT_EQ(find_edge_components(build(other)).count, 3U);
  }
}

}  // namespace
}  // namespace meshalyzer
