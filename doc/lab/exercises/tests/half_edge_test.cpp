#include "half_edge.h"

#include "shapes.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lab {
namespace {

const HalfEdge& at(const HalfEdgeMesh& mesh, int h) {
  return mesh.halfedges.at(static_cast<std::size_t>(h));
}

int n_halfedges(const HalfEdgeMesh& mesh) {
  return static_cast<int>(mesh.halfedges.size());
}

HalfEdgeMesh linked(int n_vertices, const shapes::Faces& faces) {
  HalfEdgeMesh mesh = link_faces(n_vertices, faces);
  link_pairs(mesh);
  link_borders(mesh);
  return mesh;
}

/// Vertices 0 ... 3 of a quadrilateral, cut along 0 2.
const shapes::Faces kTwoFaces{{0, 1, 2}, {0, 2, 3}};

TEST(LinkFaces, HalfEdgesStartAtTheCornersOfTheirFace) {
  const HalfEdgeMesh mesh = link_faces(4, kTwoFaces);
  ASSERT_EQ(n_halfedges(mesh), 6);
  for (int f = 0; f < 2; ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto& face = kTwoFaces.at(static_cast<std::size_t>(f));
      EXPECT_EQ(at(mesh, 3 * f + k).vertex, face.at(static_cast<std::size_t>(k)));
      EXPECT_EQ(at(mesh, 3 * f + k).face, f);
    }
  }
}

TEST(LinkFaces, ThreeStepsForwardOrBackLeadRoundTheFace) {
  const HalfEdgeMesh mesh = link_faces(4, kTwoFaces);
  ASSERT_EQ(n_halfedges(mesh), 6);
  for (int h = 0; h < 6; ++h) {
    const int next = at(mesh, h).next;
    EXPECT_EQ(at(mesh, next).prev, h);
    EXPECT_EQ(at(mesh, next).face, at(mesh, h).face);
    EXPECT_EQ(at(mesh, at(mesh, next).next).next, h);
    EXPECT_NE(next, h);
  }
}

TEST(LinkFaces, NextRunsInTheOrderOfTheCorners) {
  const HalfEdgeMesh mesh = link_faces(4, kTwoFaces);
  EXPECT_EQ(at(mesh, at(mesh, 0).next).vertex, 1);
  EXPECT_EQ(at(mesh, at(mesh, 3).next).vertex, 2);
}

TEST(LinkFaces, VerticesKnowAHalfEdgeThatStartsThereAndOrphansNone) {
  const HalfEdgeMesh mesh = link_faces(5, kTwoFaces);
  ASSERT_EQ(mesh.vertex_halfedge.size(), 5U);
  for (int v = 0; v < 4; ++v) {
    EXPECT_EQ(at(mesh, mesh.vertex_halfedge.at(static_cast<std::size_t>(v))).vertex, v);
  }
  EXPECT_EQ(mesh.vertex_halfedge.at(4), kNone);
}

TEST(LinkPairs, PairsRunAlongOneEdgeInOppositeDirections) {
  HalfEdgeMesh mesh = link_faces(4, shapes::tetrahedron_faces());
  link_pairs(mesh);
  ASSERT_EQ(n_halfedges(mesh), 12);
  for (int h = 0; h < 12; ++h) {
    const int pair = at(mesh, h).pair;
    ASSERT_NE(pair, kNone);
    EXPECT_EQ(at(mesh, pair).pair, h);
    EXPECT_EQ(at(mesh, pair).vertex, at(mesh, at(mesh, h).next).vertex);
    EXPECT_EQ(at(mesh, at(mesh, pair).next).vertex, at(mesh, h).vertex);
  }
}

TEST(LinkPairs, SidesOnTheBorderHaveNone) {
  HalfEdgeMesh mesh = link_faces(4, kTwoFaces);
  link_pairs(mesh);
  int n_without = 0;
  for (const HalfEdge& h : mesh.halfedges) n_without += h.pair == kNone ? 1 : 0;
  // Of the six sides the two along the diagonal are a pair.
  EXPECT_EQ(n_without, 4);
}

TEST(LinkPairs, ThirdFaceOnAnEdgeIsRefused) {
  HalfEdgeMesh mesh = link_faces(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_THROW(link_pairs(mesh), std::invalid_argument);
}

TEST(LinkPairs, FaceTurnedAgainstItsNeighbourIsRefused) {
  HalfEdgeMesh mesh = link_faces(4, {{0, 1, 2}, {0, 3, 2}, {2, 0, 3}});
  EXPECT_THROW(link_pairs(mesh), std::invalid_argument);
}

TEST(LinkBorders, ClosedMeshGetsNoHalfEdges) {
  EXPECT_EQ(n_halfedges(linked(4, shapes::tetrahedron_faces())), 12);
}

TEST(LinkBorders, BorderHalfEdgesFormALoopRoundTheHole) {
  const HalfEdgeMesh mesh = linked(4, kTwoFaces);
  ASSERT_EQ(n_halfedges(mesh), 10);
  int h = 6;
  for (int step = 0; step < 4; ++step) {
    EXPECT_EQ(at(mesh, h).face, kNone);
    EXPECT_EQ(at(mesh, at(mesh, h).pair).pair, h);
    EXPECT_EQ(at(mesh, at(mesh, h).next).prev, h);
    // It ends where the next one starts.
    EXPECT_EQ(at(mesh, at(mesh, h).pair).vertex, at(mesh, at(mesh, h).next).vertex);
    h = at(mesh, h).next;
    EXPECT_EQ(h == 6, step == 3);
  }
}

TEST(LinkBorders, TurningRoundABorderVertexComesBack) {
  const HalfEdgeMesh mesh = linked(6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
  const int first = mesh.vertex_halfedge.at(0);
  int n_neighbours = 0;
  int h = first;
  do {
    EXPECT_EQ(at(mesh, h).vertex, 0);
    h = at(mesh, at(mesh, h).prev).pair;
    ++n_neighbours;
  } while (h != first && n_neighbours < 10);
  EXPECT_EQ(n_neighbours, 5);
}

}  // namespace
}  // namespace lab
