#include "one_ring.h"

#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lab {
namespace {

VertexHandle vertex(int i) {
  return VertexHandle(i);
}

std::vector<int> indices(const std::vector<VertexHandle>& vertices) {
  std::vector<int> result;
  for (const VertexHandle v : vertices) result.push_back(v.idx());
  return result;
}

/// Begins with its smallest number, and goes on in the same order.
std::vector<int> from_smallest(std::vector<int> ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

TEST(OutgoingHalfedges, AllStartAtTheVertexAndNoneIsLeftOut) {
  const TriMesh mesh = shapes::cube();
  std::size_t n_halfedges = 0;
  for (const VertexHandle v : mesh.vertices()) {
    const auto ring = outgoing_halfedges(mesh, v);
    for (const HalfedgeHandle h : ring) EXPECT_EQ(mesh.from_vertex_handle(h), v);
    n_halfedges += ring.size();
  }
  // Each of the 18 edges has two half-edges, and each of these starts somewhere.
  EXPECT_EQ(n_halfedges, 36U);
}

TEST(OutgoingHalfedges, OrphanHasNone) {
  const TriMesh mesh = shapes::with_orphan(shapes::octahedron());
  EXPECT_TRUE(outgoing_halfedges(mesh, vertex(6)).empty());
}

TEST(OutgoingHalfedges, OnTheBorderOnlyTheLastHasNoFace) {
  const TriMesh mesh = shapes::square();
  const auto ring = outgoing_halfedges(mesh, vertex(1));
  ASSERT_EQ(ring.size(), 3U);
  EXPECT_TRUE(mesh.is_boundary(mesh.opposite_halfedge_handle(ring[0])));
  EXPECT_FALSE(mesh.is_boundary(ring[0]));
  EXPECT_FALSE(mesh.is_boundary(ring[1]));
  EXPECT_TRUE(mesh.is_boundary(ring[2]));
}

TEST(OneRingVertices, RunCounterClockwiseSeenFromOutside) {
  // Seen from +z, round (0, 0, 1): (1, 0), (0, 1), (-1, 0), (0, -1).
  EXPECT_EQ(from_smallest(indices(one_ring_vertices(shapes::octahedron(), vertex(2)))),
            (std::vector{0, 1, 3, 4}));
}

TEST(OneRingVertices, RunTheOtherWayWhereTheSurfaceIsInsideOut) {
  const TriMesh mesh = shapes::turned_inside_out(shapes::octahedron());
  EXPECT_EQ(from_smallest(indices(one_ring_vertices(mesh, vertex(2)))), (std::vector{0, 4, 3, 1}));
}

TEST(OneRingVertices, OnTheBorderBothEndsOfTheFanAreThere) {
  // Seen from +z the neighbours of (1, 1) lie at 180 (-1, 1), 225 (the middle) and 270 degrees
  // (1, -1).
  EXPECT_EQ(indices(one_ring_vertices(shapes::square(), vertex(1))), (std::vector{2, 0, 4}));
}

TEST(OneRingFaces, LieBetweenConsecutiveNeighbours) {
  for (const TriMesh& mesh : {shapes::cube(), shapes::square(), shapes::open_octahedron()}) {
    for (const VertexHandle v : mesh.vertices()) {
      const auto vertices = one_ring_vertices(mesh, v);
      const auto faces = one_ring_faces(mesh, v);
      for (std::size_t i = 0; i < faces.size(); ++i) {
        ASSERT_TRUE(faces[i].is_valid());
        std::vector<int> corners;
        for (const auto corner : mesh.fv_range(faces[i])) corners.push_back(corner.idx());
        const std::vector<int> want{v.idx(), vertices.at(i).idx(),
                                    vertices.at((i + 1) % vertices.size()).idx()};
        EXPECT_EQ(from_smallest(corners), from_smallest(want));
      }
    }
  }
}

TEST(OneRingFaces, AreAsManyAsNeighboursInsideAndOneLessOnTheBorder) {
  const TriMesh mesh = shapes::square();
  EXPECT_EQ(one_ring_faces(mesh, vertex(0)).size(), 4U);
  EXPECT_EQ(one_ring_faces(mesh, vertex(1)).size(), 2U);
}

TEST(IsOnBorder, VertexOfAClosedMeshIsNot) {
  const TriMesh mesh = shapes::octahedron();
  for (const VertexHandle v : mesh.vertices()) EXPECT_FALSE(is_on_border(mesh, v));
}

TEST(IsOnBorder, OnlyTheCornersOfTheMissingFaceAre) {
  const TriMesh mesh = shapes::open_octahedron();
  for (int v = 0; v < 6; ++v) EXPECT_EQ(is_on_border(mesh, vertex(v)), v < 3);
}

TEST(IsOnBorder, OrphanIsNot) {
  EXPECT_FALSE(is_on_border(shapes::with_orphan(shapes::octahedron()), vertex(6)));
}

}  // namespace
}  // namespace lab
