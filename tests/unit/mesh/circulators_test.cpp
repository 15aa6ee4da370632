#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "unit/mesh/indices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// These tests run OpenMesh's own circulators on the arrays that build() writes.
namespace meshalyzer {
namespace {

template <typename Range>
Indices sorted_indices(Range&& range) {
  Indices result = indices(range);
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Circulators, FaceVerticesComeInTheOrderOfTheFile) {
  const Soup soup = shapes::torus(2, 1, 5, 4);
  const CutMesh cut = build(soup);
  for (const FaceHandle f : cut.mesh.faces()) {
    const Triangle& t = soup.triangles[cut.side.face(f)];
    EXPECT_EQ(indices(cut.mesh.fv_range(f)), (Indices{t[0], t[1], t[2]}));
  }
}

TEST(Circulators, FaceHalfedgesAreThreeOfThatFace) {
  const CutMesh cut = build(shapes::tetrahedron());
  for (const FaceHandle f : cut.mesh.faces()) {
    EXPECT_EQ(indices(cut.mesh.fh_range(f)).size(), 3U);
    for (const HalfedgeHandle h : cut.mesh.fh_range(f)) EXPECT_EQ(cut.mesh.face_handle(h), f);
  }
}

TEST(Circulators, ClosedVertexMeetsAllItsNeighboursAndFaces) {
  const CutMesh cut = build(soup_of(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  EXPECT_EQ(sorted_indices(cut.mesh.vv_range(VertexHandle(3))), (Indices{0, 1, 2}));
  EXPECT_EQ(sorted_indices(cut.mesh.vf_range(VertexHandle(3))), (Indices{1, 2, 3}));
}

TEST(Circulators, OpenVertexMeetsAllItsNeighboursAndFaces) {
  const CutMesh cut = build(half_disc());
  EXPECT_EQ(sorted_indices(cut.mesh.vv_range(VertexHandle(0))), (Indices{1, 2, 3, 4, 5}));
  EXPECT_EQ(sorted_indices(cut.mesh.vf_range(VertexHandle(0))), (Indices{0, 1, 2, 3}));
  EXPECT_EQ(sorted_indices(cut.mesh.vv_range(VertexHandle(3))), (Indices{0, 2, 4}));
}

TEST(Circulators, BorderVertexBeginsOnTheBorder) {
  const CutMesh cut = build(half_disc());
  for (const VertexHandle v : cut.mesh.vertices()) {
    EXPECT_TRUE(cut.mesh.is_boundary(cut.mesh.halfedge_handle(v))) << "vertex " << v.idx();
    EXPECT_TRUE(cut.mesh.is_boundary(v)) << "vertex " << v.idx();
  }
}

TEST(Circulators, ClosedMeshHasNoVertexOnABorder) {
  const CutMesh cut = build(shapes::icosphere(1));
  for (const VertexHandle v : cut.mesh.vertices()) EXPECT_FALSE(cut.mesh.is_boundary(v));
}

TEST(Circulators, BorderIsWalkedWithTheHoleOnTheLeft) {
  const CutMesh cut = build(half_disc());
  // From the centre out along the last spoke's other side: 0 -> 1 is a side of face 0, so the
  // border runs 1 -> 0 -> 5.
  const HalfedgeHandle enters = cut.mesh.find_halfedge(VertexHandle(1), VertexHandle(0));
  ASSERT_TRUE(cut.mesh.is_boundary(enters));
  EXPECT_EQ(cut.mesh.to_vertex_handle(cut.mesh.next_halfedge_handle(enters)).idx(), 5);
}

TEST(Circulators, IsolatedVertexHasNoNeighbour) {
  const CutMesh cut = build(soup_of(4, {{0, 1, 3}}));
  EXPECT_EQ(cut.mesh.valence(VertexHandle(2)), 0U);
}

TEST(Circulators, FaceNeighboursAcrossACutEdgeAreNotMet) {
  const CutMesh cut = build(shapes::fan_of_three());
  for (const FaceHandle f : cut.mesh.faces()) EXPECT_TRUE(indices(cut.mesh.ff_range(f)).empty());
}

TEST(Circulators, CopyMeetsItsOwnFanOnly) {
  const CutMesh cut = build(soup_of(5, {{0, 1, 2}, {0, 3, 4}}));
  ASSERT_EQ(cut.side.copies, Indices{0});
  EXPECT_EQ(sorted_indices(cut.mesh.vv_range(VertexHandle(0))), (Indices{1, 2}));
  EXPECT_EQ(sorted_indices(cut.mesh.vv_range(VertexHandle(5))), (Indices{3, 4}));
}

}  // namespace
}  // namespace meshalyzer
