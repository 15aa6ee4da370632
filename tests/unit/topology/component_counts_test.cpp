#include "meshalyzer/topology/component_counts.h"

#include "direct_evaluation.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/edges.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<ComponentCounts> counts_of(const CutMesh& cut) {
  const Components components = find_components(cut);
  const Components edge_components = find_edge_components(cut);
  const Orientability orientability = find_orientability(cut, edge_components);
  const BoundaryLoops boundaries = find_boundary_loops(cut);
  return count_by_component(cut, {.components = components,
                                  .edge_components = edge_components,
                                  .orientability = orientability,
                                  .boundaries = boundaries});
}

/// All but the name, which depends on the order of the faces.
auto figures(const ComponentCounts& c) {
  return std::tuple(c.faces, c.vertices, c.edges, c.edge_components, c.boundaries, c.border_edges,
                    c.non_manifold_edges, c.non_manifold_vertices, c.flipped_edges, c.orientable);
}

TEST(CountByComponent, EmptyMeshHasNone) {
  EXPECT_TRUE(counts_of(build(Soup{})).empty());
}

TEST(CountByComponent, EveryCountIsOfItsComponent) {
  const std::array<Index, 1> turned{0};
  Soup soup = shapes::flipped(shapes::open_cube(), turned);
  soup = shapes::merged(soup, shapes::two_tetrahedra_sharing_vertex());
  soup = shapes::merged(soup, shapes::fan_of_three());
  soup = shapes::merged(soup, shapes::moebius_strip(5));
  soup.positions.emplace_back(9, 9, 9);
  const std::vector<ComponentCounts> counts = counts_of(build(soup));
  ASSERT_EQ(counts.size(), 4U);
  // faces, vertices, edges, edge components, boundaries, border edges, non-manifold edges and
  // vertices, flipped edges, orientable. Face 0 is at the closed bottom: three edges are flipped.
  EXPECT_EQ(figures(counts[0]), std::tuple(10, 8, 17, 1, 1, 4, 0, 0, 3, true));
  EXPECT_EQ(figures(counts[1]), std::tuple(8, 7, 12, 2, 0, 0, 0, 1, 0, true));
  EXPECT_EQ(figures(counts[2]), std::tuple(3, 5, 7, 1, 3, 6, 1, 2, 0, true));
  // The strip is cut where its last quad meets the first the wrong way.
  EXPECT_EQ(figures(counts[3]), std::tuple(10, 10, 20, 1, 1, 10, 0, 0, 1, false));
}

TEST(CountByComponent, NameIsTheLowestFaceOfTheFile) {
  // The first record is degenerate, so that mesh faces are one off.
  const Soup soup = shapes::make(std::vector<Vec3>(9, Vec3::Zero()),
                                 {{0, 0, 1}, {3, 4, 5}, {0, 1, 2}, {5, 4, 6}});
  const std::vector<ComponentCounts> counts = counts_of(build(soup));
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_EQ(counts[0].first_face, 1U);
  EXPECT_EQ(counts[1].first_face, 2U);
}

TEST(CountByComponent, FiguresAreTheSameInAnyOrder) {
  Soup soup = shapes::merged(shapes::genus_block(2), shapes::two_tetrahedra_sharing_edge());
  soup = shapes::merged(soup, shapes::without_faces(shapes::icosphere(1), std::array<Index, 1>{7}));
  soup = shapes::merged(soup, shapes::two_tetrahedra_sharing_face());
  const auto sorted_figures = [](const Soup& mesh) {
    std::multiset<decltype(figures(ComponentCounts{}))> all;
    for (const ComponentCounts& c : counts_of(build(mesh))) all.insert(figures(c));
    return all;
  };
  const auto expected = sorted_figures(soup);
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const Soup other = shapes::renumbered_vertices(shapes::shuffled_faces(soup, seed), seed);
    EXPECT_EQ(sorted_figures(other), expected);
  }
}

TEST(CountByComponent, SumsAreThoseOfTheMeshInRandomSoups) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Soup soup = direct::random_soup(seed, 1 + seed % 10);
    const direct::Complex complex = direct::complex_of(soup);
    const CutMesh cut = build(soup);
    ComponentCounts sum;
    for (const ComponentCounts& c : counts_of(cut)) {
      sum.faces += c.faces;
      sum.vertices += c.vertices;
      sum.edges += c.edges;
      sum.edge_components += c.edge_components;
      sum.boundaries += c.boundaries;
      sum.border_edges += c.border_edges;
      sum.non_manifold_edges += c.non_manifold_edges;
      sum.non_manifold_vertices += c.non_manifold_vertices;
      sum.flipped_edges += c.flipped_edges;
    }
    std::set<Index> used;
    for (const Triangle& t : complex.triangles) used.insert(t.begin(), t.end());
    EXPECT_EQ(sum.faces, complex.triangles.size());
    EXPECT_EQ(sum.vertices, used.size());
    EXPECT_EQ(sum.edges, complex.faces_at.size());
    EXPECT_EQ(sum.edge_components, find_edge_components(cut).count);
    EXPECT_EQ(sum.boundaries, direct::boundaries(complex).size());
    EXPECT_EQ(sum.border_edges, direct::edges_with(complex, 1).size());
    EXPECT_EQ(sum.non_manifold_edges, cut.side.non_manifold_edges.size());
    EXPECT_EQ(sum.non_manifold_vertices, cut.side.non_manifold_vertices.size());
    EXPECT_EQ(sum.flipped_edges, cut.side.flipped_edges.size());
  }
}

}  // namespace
}  // namespace meshalyzer
