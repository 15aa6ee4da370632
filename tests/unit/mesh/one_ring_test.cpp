#include "meshalyzer/mesh/one_ring.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "unit/mesh/indices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

namespace meshalyzer {
namespace {

static_assert(std::forward_iterator<OneRingIterator<VertexHandle>>);
static_assert(std::forward_iterator<OneRingIterator<FaceHandle>>);
static_assert(std::forward_iterator<OneRingIterator<HalfedgeHandle>>);

/// Begins with its smallest element, in the same circular order.
Indices from_smallest(Indices ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

/// Six vertices round vertex 0 at the corners of a hexagon that faces up, their faces in any order.
Soup hexagon() {
  Soup soup = shapes::make({{0, 0, 0}}, {});
  for (int i = 0; i < 6; ++i) {
    soup.positions.emplace_back(std::cos(i * std::numbers::pi / 3),
                                std::sin(i * std::numbers::pi / 3), 0.1 * (i % 2));
  }
  soup.triangles = {{0, 3, 4}, {1, 2, 0}, {6, 1, 0}, {0, 2, 3}, {5, 6, 0}, {4, 5, 0}};
  return soup;
}

TEST(OneRing, ClosedFanIsWalkedOnce) {
  const CutMesh cut = build(hexagon());
  const VertexHandle v(0);
  EXPECT_EQ(from_smallest(indices(one_ring_vertices(cut.mesh, v))), (Indices{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(from_smallest(indices(one_ring_faces(cut.mesh, v))), (Indices{0, 5, 4, 2, 1, 3}));
  EXPECT_EQ(indices(one_ring_halfedges(cut.mesh, v)).size(), 6U);
}

TEST(OneRing, BorderFanIsWalkedFromItsFirstEdgeToItsLast) {
  const CutMesh cut = build(half_disc());
  const VertexHandle v(0);
  EXPECT_EQ(indices(one_ring_vertices(cut.mesh, v)), (Indices{1, 2, 3, 4, 5}));
  EXPECT_EQ(indices(one_ring_faces(cut.mesh, v)), (Indices{0, 1, 2, 3}));
  const OneRing<HalfedgeHandle> halfedges = one_ring_halfedges(cut.mesh, v);
  EXPECT_EQ(std::distance(halfedges.begin(), halfedges.end()), 5);
  for (const HalfedgeHandle h : halfedges) {
    EXPECT_EQ(cut.mesh.is_boundary(h), cut.mesh.to_vertex_handle(h).idx() == 5);
  }
}

TEST(OneRing, CornerOfOneFaceHasTwoNeighbours) {
  const CutMesh cut = build(soup_of(3, {{0, 1, 2}}));
  EXPECT_EQ(indices(one_ring_vertices(cut.mesh, VertexHandle(0))), (Indices{1, 2}));
  EXPECT_EQ(indices(one_ring_vertices(cut.mesh, VertexHandle(1))), (Indices{2, 0}));
  EXPECT_EQ(indices(one_ring_faces(cut.mesh, VertexHandle(2))), Indices{0});
}

TEST(OneRing, IsolatedVertexHasNone) {
  const CutMesh cut = build(soup_of(4, {{0, 1, 3}}));
  EXPECT_TRUE(one_ring_vertices(cut.mesh, VertexHandle(2)).empty());
  EXPECT_TRUE(indices(one_ring_faces(cut.mesh, VertexHandle(2))).empty());
  EXPECT_TRUE(indices(one_ring_halfedges(cut.mesh, VertexHandle(2))).empty());
  EXPECT_FALSE(one_ring_faces(cut.mesh, VertexHandle(3)).empty());
}

TEST(OneRing, ElementsOfTheSameStepBelongTogether) {
  for (const Soup& soup : {shapes::icosphere(1), shapes::open_cube(), shapes::moebius_strip(7)}) {
    const CutMesh cut = build(soup);
    for (const VertexHandle v : cut.mesh.vertices()) {
      auto vertex = one_ring_vertices(cut.mesh, v).begin();
      auto face = one_ring_faces(cut.mesh, v).begin();
      for (const HalfedgeHandle h : one_ring_halfedges(cut.mesh, v)) {
        EXPECT_EQ(cut.mesh.from_vertex_handle(h), v);
        EXPECT_EQ(*vertex++, cut.mesh.to_vertex_handle(h));
        if (!cut.mesh.is_boundary(h)) {
          EXPECT_EQ(*face++, cut.mesh.face_handle(h));
        }
      }
      EXPECT_EQ(vertex, one_ring_vertices(cut.mesh, v).end());
      EXPECT_EQ(face, one_ring_faces(cut.mesh, v).end());
    }
  }
}

TEST(OneRing, NeighboursTurnLeftSeenFromOutsideASphere) {
  const Soup ball = shapes::icosphere(2);
  const CutMesh cut = build(ball);
  for (const VertexHandle v : cut.mesh.vertices()) {
    const Vec3& normal = cut.mesh.point(v);
    Indices ring = indices(one_ring_vertices(cut.mesh, v));
    ring.push_back(ring.front());
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      const Vec3 from = ball.positions[ring[i]] - normal;
      const Vec3 to = ball.positions[ring[i + 1]] - normal;
      EXPECT_GT(from.cross(to).dot(normal), 0.0);
    }
  }
}

TEST(OneRing, EveryFaceIsMetAtEachOfItsCorners) {
  // The cut mesh of three faces on one edge, and of a pinched vertex.
  for (const Soup& soup : {shapes::fan_of_three(), shapes::two_tetrahedra_sharing_vertex()}) {
    const CutMesh cut = build(soup);
    std::vector<int> met(soup.n_faces(), 0);
    for (const VertexHandle v : cut.mesh.vertices()) {
      for (const Index f : indices(one_ring_faces(cut.mesh, v))) ++met[f];
    }
    EXPECT_EQ(met, std::vector<int>(soup.n_faces(), 3));
  }
}

TEST(OneRing, CopyOfAPinchedVertexHasItsOwnFan) {
  const CutMesh cut = build(soup_of(5, {{0, 1, 2}, {0, 3, 4}}));
  EXPECT_EQ(indices(one_ring_vertices(cut.mesh, VertexHandle(0))), (Indices{1, 2}));
  EXPECT_EQ(indices(one_ring_vertices(cut.mesh, VertexHandle(5))), (Indices{3, 4}));
}

TEST(OneRing, MayBeWalkedAgainFromTheSamePlace) {
  const CutMesh cut = build(half_disc());
  const OneRing<VertexHandle> ring = one_ring_vertices(cut.mesh, VertexHandle(0));
  auto place = std::next(ring.begin(), 2);
  const auto kept = place++;
  EXPECT_EQ((*kept).idx(), 3);
  EXPECT_EQ((*place).idx(), 4);
  EXPECT_EQ(std::next(kept), place);
  EXPECT_EQ(indices(ring), indices(ring));
}

}  // namespace
}  // namespace meshalyzer
