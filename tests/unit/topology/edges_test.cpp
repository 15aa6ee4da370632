#include "meshalyzer/topology/edges.h"

#include "direct_evaluation.h"
#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace meshalyzer {
namespace {

TEST(NEdges, EmptyMeshHasNone) {
  EXPECT_EQ(n_edges(build(Soup{})), 0U);
}

TEST(NEdges, SingleFaceHasItsSides) {
  EXPECT_EQ(n_edges(build(shapes::make(std::vector<Vec3>(3, Vec3::Zero()), {{0, 1, 2}}))), 3U);
}

TEST(NEdges, ClosedManifoldHasThreeHalvesOfItsFaces) {
  // Each face has three edges, each edge two faces.
  EXPECT_EQ(n_edges(build(shapes::cube())), 18U);
  EXPECT_EQ(n_edges(build(shapes::icosphere(2))), 480U);
  EXPECT_EQ(n_edges(build(shapes::torus(3, 1, 7, 5))), 105U);
  EXPECT_EQ(n_edges(build(shapes::genus_block(3))), 204U);
}

TEST(NEdges, CutEdgeCountsOnce) {
  EXPECT_EQ(n_edges(build(shapes::fan_of_three())), 7U);
  EXPECT_EQ(n_edges(build(shapes::two_tetrahedra_sharing_edge())), 11U);
  EXPECT_EQ(n_edges(build(shapes::two_tetrahedra_sharing_face())), 9U);
  EXPECT_EQ(n_edges(build(shapes::moebius_strip(6))), 24U);
  EXPECT_EQ(n_edges(build(shapes::projective_plane())), 15U);
}

TEST(VertexValences, EdgesAtEachVertexOfTheComplexAreCounted) {
  // The axis, and two edges for each vertex off it; the axis' ends have it and three more.
  EXPECT_EQ(vertex_valences(build(shapes::fan_of_three())), (std::vector<Index>{4, 4, 2, 2, 2}));
  // The tip of the two tetrahedra has three edges of each.
  EXPECT_EQ(vertex_valences(build(shapes::two_tetrahedra_sharing_vertex())),
            (std::vector<Index>{6, 3, 3, 3, 3, 3, 3}));
  // Each of the six vertices is joined to the five others.
  EXPECT_EQ(vertex_valences(build(shapes::projective_plane())), std::vector<Index>(6, 5));
}

TEST(VertexValences, UnusedVertexHasNone) {
  Soup soup = shapes::tetrahedron();
  soup.positions.emplace_back(9, 9, 9);
  EXPECT_EQ(vertex_valences(build(soup)), (std::vector<Index>{3, 3, 3, 3, 0}));
}

TEST(FileEnds, BothHalvesOfAnEdgeNameTheSameFileVertices) {
  const CutMesh cut = build(shapes::two_tetrahedra_sharing_vertex());
  for (const EdgeHandle e : cut.mesh.all_edges()) {
    auto ends = file_ends(cut, cut.mesh.halfedge_handle(e, 0));
    std::reverse(ends.begin(), ends.end());
    EXPECT_EQ(ends, file_ends(cut, cut.mesh.halfedge_handle(e, 1)));
    EXPECT_LT(std::max(ends[0], ends[1]), 7U);
    std::sort(ends.begin(), ends.end());
    EXPECT_EQ(ascending_file_ends(cut, cut.mesh.halfedge_handle(e, 0)), ends);
  }
}

TEST(ClassifyEdges, AgreesWithDirectEvaluationOnRandomSoups) {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Soup soup = direct::random_soup(seed, 1 + seed % 24);
    const direct::Complex complex = direct::complex_of(soup);
    const CutMesh cut = build(soup);
    EXPECT_EQ(n_edges(cut), complex.faces_at.size());
    std::vector<Index> valences(soup.positions.size(), 0);
    for (const auto& [edge, faces] : complex.faces_at) {
      ++valences[edge.first];
      ++valences[edge.second];
    }
    EXPECT_EQ(vertex_valences(cut), valences);
    const std::vector<EdgeKind> kinds = classify_edges(cut);
    std::map<direct::Edge, std::size_t> n_mesh_edges;
    for (const EdgeHandle e : cut.mesh.all_edges()) {
      const direct::Edge edge = direct::edge_of(cut, cut.mesh.halfedge_handle(e, 0));
      const std::size_t n_faces = complex.faces_at.at(edge).size();
      ++n_mesh_edges[edge];
      switch (kinds[static_cast<std::size_t>(e.idx())]) {
        case EdgeKind::Inner:
        case EdgeKind::Flipped:
          EXPECT_EQ(n_faces, 2U);
          break;
        case EdgeKind::Border:
          EXPECT_EQ(n_faces, 1U);
          break;
        case EdgeKind::NonManifold:
          EXPECT_GT(n_faces, 2U);
          break;
      }
      const bool is_inner = kinds[static_cast<std::size_t>(e.idx())] == EdgeKind::Inner;
      EXPECT_EQ(is_inner, !cut.mesh.is_boundary(e));
    }
    EXPECT_EQ(n_mesh_edges.size(), complex.faces_at.size());
  }
}

}  // namespace
}  // namespace meshalyzer
