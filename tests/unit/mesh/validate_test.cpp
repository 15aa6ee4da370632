#include "meshalyzer/mesh/validate.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"
#include "support/soups.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using Sentences = std::vector<std::string>;

bool mentions(const Sentences& sentences, const std::string& words) {
  for (const std::string& sentence : sentences) {
    if (sentence.find(words) != std::string::npos) return true;
  }
  return false;
}

/// A mesh with something of everything: a pinched vertex, a non-manifold edge, a flipped edge, a
/// rejected face.
Soup mixed_soup() {
  return soup_of(12, {{0, 1, 2},
                      {1, 0, 3},
                      {0, 1, 4},  // third on 0 1
                      {2, 5, 6},  // pinch at 2
                      {5, 6, 7},  // flipped on 5 6
                      {8, 8, 9},  // degenerate
                      {8, 9, 10}});
}

TEST(Validate, WhatBuildMakesHasNoFault) {
  const Soup soup = mixed_soup();
  EXPECT_EQ(validate(build(soup), soup), Sentences{});
}

TEST(Validate, HandleOutOfRangeIsSaidAndNotFollowed) {
  const Soup soup = shapes::tetrahedron();
  CutMesh cut = build(soup);
  cut.mesh.set_halfedge_handle(VertexHandle(2), HalfedgeHandle(99));
  EXPECT_EQ(validate(cut, soup), Sentences{"vertex 2: no half-edge 99"});
}

TEST(Validate, NextAndPreviousNotInverseIsSaid) {
  const Soup soup = shapes::tetrahedron();
  CutMesh cut = build(soup);
  cut.mesh.set_prev_halfedge_handle(HalfedgeHandle(0), HalfedgeHandle(0));
  EXPECT_TRUE(mentions(validate(cut, soup), "next and previous are not inverse"));
}

TEST(Validate, VertexThatDoesNotBeginOnItsBorderIsSaid) {
  const Soup soup = soup_of(3, {{0, 1, 2}});
  CutMesh cut = build(soup);
  const HalfedgeHandle inner = cut.mesh.find_halfedge(VertexHandle(1), VertexHandle(2));
  cut.mesh.set_halfedge_handle(VertexHandle(1), inner);
  EXPECT_EQ(validate(cut, soup), Sentences{"vertex 1: its half-edge is not the one on the border"});
}

TEST(Validate, TwoFansAtOneMeshVertexAreSaid) {
  // The copy's half-edges are given back to the vertex it is a copy of, as add_face() leaves them.
  const Soup soup = soup_of(5, {{0, 1, 2}, {0, 3, 4}});
  CutMesh cut = build(soup);
  for (const HalfedgeHandle h : cut.mesh.halfedges()) {
    if (cut.mesh.to_vertex_handle(h).idx() == 5) cut.mesh.set_vertex_handle(h, VertexHandle(0));
  }
  EXPECT_TRUE(mentions(validate(cut, soup), "vertex 0: its faces are not one fan"));
}

TEST(Validate, TwoFansLinkedThroughTheirBordersAreSaid) {
  // The same, with each border going on along the other fan: turning round the vertex meets every
  // face.
  const Soup soup = soup_of(5, {{0, 1, 2}, {0, 3, 4}});
  CutMesh cut = build(soup);
  const VertexHandle copy(5);
  const HalfedgeHandle out_of_one = cut.mesh.halfedge_handle(VertexHandle(0));
  const HalfedgeHandle out_of_other = cut.mesh.halfedge_handle(copy);
  const HalfedgeHandle into_one = cut.mesh.prev_halfedge_handle(out_of_one);
  const HalfedgeHandle into_other = cut.mesh.prev_halfedge_handle(out_of_other);
  for (const HalfedgeHandle h : cut.mesh.halfedges()) {
    if (cut.mesh.to_vertex_handle(h) == copy) cut.mesh.set_vertex_handle(h, VertexHandle(0));
  }
  cut.mesh.set_next_halfedge_handle(into_one, out_of_other);
  cut.mesh.set_next_halfedge_handle(into_other, out_of_one);
  cut.mesh.set_isolated(copy);
  EXPECT_EQ(validate(cut, soup), Sentences{"vertex 0: its faces are not one fan"});
}

TEST(Validate, FaceMayBeginAtAnyCorner) {
  const Soup soup = shapes::tetrahedron();
  CutMesh cut = build(soup);
  for (const FaceHandle f : cut.mesh.faces()) {
    cut.mesh.set_halfedge_handle(f, cut.mesh.next_halfedge_handle(cut.mesh.halfedge_handle(f)));
  }
  EXPECT_EQ(validate(cut, soup), Sentences{});
}

TEST(Validate, MovedVertexIsSaid) {
  const Soup soup = shapes::tetrahedron();
  CutMesh cut = build(soup);
  cut.mesh.point(VertexHandle(3)).x() += 1e-15;
  EXPECT_EQ(validate(cut, soup),
            Sentences{"vertex 3: it does not lie where vertex 3 of the file does"});
}

TEST(Validate, CopyOfAnotherVertexIsSaid) {
  const Soup soup = soup_of(5, {{0, 1, 2}, {0, 3, 4}});
  CutMesh cut = build(soup);
  cut.side.copies[0] = 1;
  EXPECT_TRUE(mentions(validate(cut, soup), "face 1: glued, it is not face 1 of the file"));
}

TEST(Validate, FaceOfTheOtherOrientationIsSaid) {
  Soup soup = soup_of(3, {{0, 1, 2}});
  const CutMesh cut = build(soup);
  soup.triangles[0] = {0, 2, 1};
  EXPECT_EQ(validate(cut, soup), Sentences{"face 0: glued, it is not face 0 of the file"});
}

TEST(Validate, FaceNotHeldIsSaid) {
  Soup soup = shapes::tetrahedron();
  const CutMesh cut = build(soup);
  soup.triangles.push_back({0, 1, 1});
  EXPECT_EQ(validate(cut, soup), Sentences{"0 rejected faces are not the 1 that cannot be held"});
}

TEST(Validate, CutThatNeedNotBeIsSaid) {
  // Two faces that share the edge of vertices 1 and 2, held as two pieces: well formed, but not
  // minimal.
  const Soup soup = soup_of(4, {{0, 1, 2}, {2, 1, 3}});
  Soup unwelded = soup;
  unwelded.positions.push_back(soup.positions[1]);
  unwelded.positions.push_back(soup.positions[2]);
  unwelded.triangles[1] = {5, 4, 3};
  CutMesh cut = build(unwelded);
  cut.side.n_file_vertices = 4;
  cut.side.copies = {1, 2};
  EXPECT_EQ(validate(cut, soup),
            Sentences{"edge 1 2 of the file is cut, though its two faces agree"});
}

TEST(Validate, CopiesInAnotherOrderThanTheirFacesAreSaid) {
  const Soup soup = soup_of(5, {{0, 1, 2}, {0, 3, 4}});
  // The same mesh with the copy and the vertex changing places: face 1 at the vertex, face 0 at the
  // copy.
  Soup split = soup_of(6, {{5, 1, 2}, {0, 3, 4}});
  split.positions[5] = split.positions[0];
  CutMesh cut = build(split);
  cut.side.n_file_vertices = 5;
  cut.side.copies = {0};
  cut.side.non_manifold_vertices = {0};
  EXPECT_EQ(validate(cut, soup),
            Sentences{"vertex 5: a copy of vertex 0 out of order, or without faces"});
}

TEST(Validate, NonManifoldEdgeLeftOutIsSaid) {
  const Soup soup = shapes::fan_of_three();
  CutMesh cut = build(soup);
  cut.side.non_manifold_edges = {};
  EXPECT_EQ(validate(cut, soup), Sentences{"0 non-manifold edges are listed where 1 are"});
}

TEST(Validate, HalfedgesOfACutEdgeInAnotherOrderAreSaid) {
  const Soup soup = shapes::fan_of_three();
  CutMesh cut = build(soup);
  std::swap(cut.side.non_manifold_edges.halfedges[0], cut.side.non_manifold_edges.halfedges[2]);
  EXPECT_TRUE(mentions(validate(cut, soup),
                       "is not listed with its half-edges among the non-manifold edges"));
}

TEST(Validate, FlippedEdgeLeftOutIsSaid) {
  const Soup soup = shapes::moebius_strip(4);
  CutMesh cut = build(soup);
  cut.side.flipped_edges = {};
  EXPECT_EQ(validate(cut, soup), Sentences{"0 flipped edges are listed where 1 are"});
}

TEST(Validate, NonManifoldVertexLeftOutIsSaid) {
  const Soup soup = shapes::two_tetrahedra_sharing_vertex();
  CutMesh cut = build(soup);
  cut.side.non_manifold_vertices.clear();
  EXPECT_EQ(validate(cut, soup),
            Sentences{"the 0 non-manifold vertices listed are not the 1 that are"});
}

TEST(Validate, SaysNoMoreThanAskedFor) {
  const Soup soup = shapes::cube();
  CutMesh cut = build(soup);
  for (const VertexHandle v : cut.mesh.vertices()) cut.mesh.point(v).x() += 1;
  EXPECT_EQ(validate(cut, soup, 3).size(), 3U);
}

}  // namespace
}  // namespace meshalyzer
