#include "meshalyzer/mesh/build.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/validate.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "unit/mesh/indices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Builds, and lets the independent checker have its say.
CutMesh checked_build(const Soup& soup) {
  CutMesh cut = build(soup);
  EXPECT_EQ(validate(cut, soup), std::vector<std::string>{});
  return cut;
}

std::size_t n_border_halfedges(const TriMesh& mesh) {
  std::size_t n = 0;
  for (const HalfedgeHandle h : mesh.halfedges()) n += mesh.is_boundary(h) ? 1 : 0;
  return n;
}

/// The file's faces at a cut edge, in the order of its half-edges.
Indices faces_at(const CutMesh& cut, const CutEdge& edge) {
  Indices faces;
  for (const HalfedgeHandle h : edge.halfedges)
    faces.push_back(cut.side.face(cut.mesh.face_handle(h)));
  return faces;
}

/// The two file vertices of a cut edge, ascending.
Indices ends_of(const CutMesh& cut, const CutEdge& edge) {
  const HalfedgeHandle h = edge.halfedges[0];
  Indices ends{cut.side.vertex(cut.mesh.from_vertex_handle(h)),
               cut.side.vertex(cut.mesh.to_vertex_handle(h))};
  std::sort(ends.begin(), ends.end());
  return ends;
}

TEST(Build, ClosedManifoldIsHeldAsItIs) {
  const CutMesh cut = checked_build(shapes::tetrahedron());
  EXPECT_EQ(cut.mesh.n_vertices(), 4U);
  EXPECT_EQ(cut.mesh.n_edges(), 6U);
  EXPECT_EQ(cut.mesh.n_faces(), 4U);
  EXPECT_EQ(n_border_halfedges(cut.mesh), 0U);
  EXPECT_TRUE(cut.side.copies.empty());
  EXPECT_EQ(cut.side.faces, (Indices{0, 1, 2, 3}));
}

TEST(Build, PositionsAreTheFiles) {
  const Soup soup = shapes::uv_sphere(5, 7);
  const CutMesh cut = checked_build(soup);
  ASSERT_EQ(cut.mesh.n_vertices(), soup.n_vertices());
  for (const VertexHandle v : cut.mesh.vertices()) {
    EXPECT_EQ(cut.mesh.point(v), soup.positions[static_cast<std::size_t>(v.idx())]);
  }
}

TEST(Build, OpenSurfaceHasItsBorderInOneLoop) {
  // A square of 3 x 2 cells: border 2 (3 + 2) = 10; E = (3 F + border) / 2 = (36 + 10) / 2.
  const CutMesh cut = checked_build(shapes::grid(3, 2));
  EXPECT_EQ(cut.mesh.n_edges(), 23U);
  EXPECT_EQ(n_border_halfedges(cut.mesh), 10U);
  HalfedgeHandle first;
  for (const HalfedgeHandle h : cut.mesh.halfedges()) {
    if (cut.mesh.is_boundary(h)) first = h;
  }
  std::size_t length = 0;
  HalfedgeHandle h = first;
  do {
    ++length;
    h = cut.mesh.next_halfedge_handle(h);
  } while (h != first && length <= 10);
  EXPECT_EQ(length, 10U);
}

TEST(Build, PillowIsClosed) {
  const CutMesh cut = checked_build(shapes::pillow());
  EXPECT_EQ(cut.mesh.n_edges(), 3U);
  EXPECT_EQ(n_border_halfedges(cut.mesh), 0U);
  EXPECT_TRUE(cut.side.copies.empty());
  EXPECT_TRUE(cut.side.non_manifold_vertices.empty());
}

TEST(Build, VertexOfTwoFansIsCopiedForTheSecond) {
  const Soup soup = shapes::two_tetrahedra_sharing_vertex();
  const CutMesh cut = checked_build(soup);
  ASSERT_EQ(cut.side.copies.size(), 1U);
  const Index shared = cut.side.copies[0];
  EXPECT_EQ(cut.side.non_manifold_vertices, Indices{shared});
  EXPECT_EQ(cut.mesh.n_edges(), 12U);
  EXPECT_EQ(n_border_halfedges(cut.mesh), 0U);
  // The file vertex keeps the fan of its lowest face.
  Index lowest = 0;
  while (std::ranges::count(soup.triangles[lowest], shared) == 0) ++lowest;
  const auto fan = cut.mesh.vf_range(VertexHandle(static_cast<int>(shared)));
  EXPECT_TRUE(std::any_of(fan.begin(), fan.end(),
                          [&](FaceHandle f) { return cut.side.face(f) == lowest; }));
}

TEST(Build, EdgeOfFourFacesIsCutInFour) {
  // Each tetrahedron loses one joint, so it keeps one fan at each end of the edge: one copy an end.
  const CutMesh cut = checked_build(shapes::two_tetrahedra_sharing_edge());
  ASSERT_EQ(cut.side.non_manifold_edges.size(), 1U);
  EXPECT_EQ(cut.side.non_manifold_edges[0].halfedges.size(), 4U);
  EXPECT_EQ(ends_of(cut, cut.side.non_manifold_edges[0]), (Indices{0, 3}));
  EXPECT_TRUE(std::ranges::is_sorted(faces_at(cut, cut.side.non_manifold_edges[0])));
  EXPECT_EQ(cut.side.copies, (Indices{0, 3}));
  EXPECT_EQ(cut.side.non_manifold_vertices, (Indices{0, 3}));
  EXPECT_EQ(cut.mesh.n_edges(), 14U);  // 11 - 1 + 4
  EXPECT_EQ(n_border_halfedges(cut.mesh), 4U);
}

TEST(Build, FaceTwiceBetweenTwoTetrahedraComesOffBoth) {
  // At each of the three vertices: two single faces, and two pairs that an edge to an apex joins.
  const CutMesh cut = checked_build(soup_of(5, {{0, 2, 1},
                                                {0, 1, 3},
                                                {1, 2, 3},
                                                {2, 0, 3},  //
                                                {0, 1, 2},
                                                {1, 0, 4},
                                                {2, 1, 4},
                                                {0, 2, 4}}));
  EXPECT_EQ(cut.side.copies, (Indices{0, 0, 0, 1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(cut.side.non_manifold_vertices, (Indices{0, 1, 2}));
  ASSERT_EQ(cut.side.non_manifold_edges.size(), 3U);
  EXPECT_EQ(faces_at(cut, cut.side.non_manifold_edges[0]), (Indices{0, 1, 4, 5}));  // 0 1
  EXPECT_EQ(faces_at(cut, cut.side.non_manifold_edges[1]), (Indices{0, 3, 4, 7}));  // 0 2
  EXPECT_EQ(faces_at(cut, cut.side.non_manifold_edges[2]), (Indices{0, 2, 4, 6}));  // 1 2
  EXPECT_EQ(cut.mesh.n_edges(), 18U);                                               // 9 - 3 + 12
}

TEST(Build, ThreeFacesOnAnEdgeAreThreePieces) {
  const CutMesh cut = checked_build(shapes::fan_of_three());
  EXPECT_EQ(cut.side.copies, (Indices{0, 0, 1, 1}));
  EXPECT_EQ(cut.side.non_manifold_vertices, (Indices{0, 1}));
  ASSERT_EQ(cut.side.non_manifold_edges.size(), 1U);
  EXPECT_EQ(faces_at(cut, cut.side.non_manifold_edges[0]), (Indices{0, 1, 2}));
  EXPECT_EQ(cut.mesh.n_edges(), 9U);
}

TEST(Build, FinOnAClosedSurfaceLeavesTwoBorderEdgesBetweenTheSameVertices) {
  Soup soup = soup_of(5, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}});
  const CutMesh cut = checked_build(soup);
  EXPECT_EQ(cut.side.copies, (Indices{0, 1}));  // those of the fin, which is the last face
  std::vector<HalfedgeHandle> slit;
  for (const HalfedgeHandle h : cut.mesh.halfedges()) {
    if (cut.mesh.is_boundary(h) && cut.mesh.from_vertex_handle(h).idx() < 4 &&
        cut.mesh.to_vertex_handle(h).idx() < 4) {
      slit.push_back(h);
    }
  }
  ASSERT_EQ(slit.size(), 2U);
  EXPECT_EQ(cut.mesh.next_halfedge_handle(slit[0]), slit[1]);
  EXPECT_EQ(cut.mesh.next_halfedge_handle(slit[1]), slit[0]);
  EXPECT_EQ(cut.mesh.from_vertex_handle(slit[0]), cut.mesh.to_vertex_handle(slit[1]));
}

TEST(Build, MoebiusStripIsCutAcrossOnce) {
  // The cut edge runs from border to border: both ends are copied, and glued again they are one
  // fan.
  const CutMesh cut = checked_build(shapes::moebius_strip(5));
  EXPECT_EQ(cut.side.flipped_edges.size(), 1U);
  EXPECT_EQ(cut.side.copies.size(), 2U);
  EXPECT_TRUE(cut.side.non_manifold_edges.halfedges.empty());
  EXPECT_TRUE(cut.side.non_manifold_vertices.empty());
  EXPECT_EQ(cut.mesh.n_edges(), 21U);  // 4 n + 1
}

TEST(Build, FaceTurnedOverIsCutOutButItsVerticesStayManifold) {
  const CutMesh cut = checked_build(soup_of(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}));
  ASSERT_EQ(cut.side.flipped_edges.size(), 3U);
  EXPECT_EQ(faces_at(cut, cut.side.flipped_edges[0]), (Indices{0, 3}));  // 0 2
  EXPECT_EQ(faces_at(cut, cut.side.flipped_edges[1]), (Indices{1, 3}));  // 0 3
  EXPECT_EQ(faces_at(cut, cut.side.flipped_edges[2]), (Indices{2, 3}));  // 2 3
  EXPECT_EQ(cut.side.copies, (Indices{0, 2, 3}));
  EXPECT_TRUE(cut.side.non_manifold_vertices.empty());
}

TEST(Build, FaceGivenTwiceIsTwoPiecesThatFlippedEdgesJoin) {
  const CutMesh cut = checked_build(soup_of(3, {{0, 1, 2}, {1, 2, 0}}));
  EXPECT_EQ(cut.side.flipped_edges.size(), 3U);
  EXPECT_EQ(cut.side.copies, (Indices{0, 1, 2}));
  EXPECT_TRUE(cut.side.non_manifold_vertices.empty());
  EXPECT_EQ(cut.mesh.n_edges(), 6U);
}

TEST(Build, PinchBesideFlippedEdgesIsStillNonManifold) {
  // At vertex 0 two pairs of faces; a flipped edge joins the two of each pair, nothing joins the
  // pairs.
  const CutMesh cut = checked_build(soup_of(7, {{0, 1, 2}, {0, 1, 3}, {0, 4, 5}, {0, 4, 6}}));
  EXPECT_EQ(cut.side.flipped_edges.size(), 2U);
  EXPECT_EQ(cut.side.copies, (Indices{0, 0, 0, 1, 4}));
  EXPECT_EQ(cut.side.non_manifold_vertices, Indices{0});
}

TEST(Build, FacesThatNameNoTriangleAreRejected) {
  const CutMesh cut =
      checked_build(soup_of(4, {{0, 0, 1}, {0, 1, 2}, {1, kNoIndex, 2}, {2, 1, 3}, {3, 3, 3}}));
  EXPECT_EQ(cut.side.faces, (Indices{1, 3}));
  EXPECT_EQ(cut.side.rejected_faces, (Indices{0, 2, 4}));
  EXPECT_EQ(cut.mesh.n_edges(), 5U);
}

TEST(Build, VerticesWithoutFacesAreIsolated) {
  const CutMesh cut = checked_build(soup_of(6, {{1, 2, 4}, {3, 3, 1}}));
  Indices isolated;
  for (const VertexHandle v : cut.mesh.vertices()) {
    if (cut.mesh.is_isolated(v)) isolated.push_back(static_cast<Index>(v.idx()));
  }
  EXPECT_EQ(isolated, (Indices{0, 3, 5}));
}

TEST(Build, NothingGivesNothing) {
  const CutMesh cut = checked_build(Soup{});
  EXPECT_TRUE(cut.mesh.vertices_empty());
  EXPECT_TRUE(cut.mesh.edges_empty());
  EXPECT_EQ(cut.side.non_manifold_edges.size(), 0U);
}

TEST(Build, VertexOfVeryManyFansIsCopiedForEach) {
  // Single faces round vertex 0, each with two vertices of its own.
  constexpr Index kFaces = 1000;
  std::vector<Triangle> triangles;
  for (Index i = 0; i < kFaces; ++i) triangles.push_back({2 * i + 1, 2 * i + 2, 0});
  const CutMesh cut = checked_build(soup_of(2 * kFaces + 1, std::move(triangles)));
  EXPECT_EQ(cut.side.copies, Indices(kFaces - 1, 0));
  EXPECT_EQ(cut.side.non_manifold_vertices, Indices{0});
}

/// A torus of n x n squares with vertices in random order, some faces turned and some given twice.
Soup damaged_torus(Index n) {
  std::vector<Index> name(std::size_t{n} * n);
  std::iota(name.begin(), name.end(), Index{0});
  std::shuffle(name.begin(), name.end(), std::mt19937(3));
  const auto at = [&](Index x, Index y) { return name[std::size_t{x % n} * n + y % n]; };
  std::vector<Triangle> faces;
  for (Index x = 0; x < n; ++x) {
    for (Index y = 0; y < n; ++y) {
      faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
      if (faces.size() % 97 == 0) std::swap(faces.back()[0], faces.back()[1]);
      if (faces.size() % 101 == 0) faces.push_back(faces.back());
    }
  }
  return shapes::make(std::vector<Vec3>(name.size(), Vec3::Zero()), faces);
}

TEST(Build, VerticesOfSeveralRangesAreBuiltAlikeByAnyNumberOfThreads) {
  // Sides are paired by ranges of 4096 vertices.
  const Soup soup = damaged_torus(150);
  const auto built = [&](std::size_t n_threads) {
    const ThreadLimit limit(n_threads);
    return checked_build(soup);
  };
  const CutMesh one = built(1);
  const CutMesh four = built(4);
  EXPECT_GT(one.side.non_manifold_edges.size(), 100U);
  EXPECT_GT(one.side.flipped_edges.size(), 100U);
  EXPECT_EQ(one.side.non_manifold_edges.halfedges, four.side.non_manifold_edges.halfedges);
  EXPECT_EQ(one.side.flipped_edges.halfedges, four.side.flipped_edges.halfedges);
  EXPECT_EQ(one.side.copies, four.side.copies);
  ASSERT_EQ(one.mesh.n_halfedges(), four.mesh.n_halfedges());
  for (const HalfedgeHandle h : one.mesh.halfedges()) {
    ASSERT_EQ(one.mesh.next_halfedge_handle(h), four.mesh.next_halfedge_handle(h));
    ASSERT_EQ(one.mesh.to_vertex_handle(h), four.mesh.to_vertex_handle(h));
  }
}

TEST(Build, CornerThatIsNoVertexIsRefused) {
  EXPECT_THROW((void)build(soup_of(3, {{0, 1, 2}, {0, 1, 3}})), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
