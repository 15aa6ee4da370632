#include "meshalyzer/repair/folds/internal/layer_join.h"

#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

VertexHandle vertex(int i) {
  return VertexHandle(i);
}

/// Two fans of five faces, round the vertices 2 and 3, with a common edge from vertex 0 to 1, and a
/// common face beside vertex 5 of the first.
///
/// @param other  The vertex of the second fan in the place of vertex 5: that one, or vertex 9.
TriMesh two_fans(Index other) {
  std::vector<Vec3> positions;
  for (int i = 0; i < 10; ++i) positions.emplace_back(i, i * i, i * i * i);
  const Soup soup = shapes::make(positions, {{0, 1, 2},
                                             {1, 4, 2},
                                             {4, 5, 2},
                                             {5, 6, 2},
                                             {6, 0, 2},
                                             {1, 0, 3},
                                             {0, 7, 3},
                                             {7, other, 3},
                                             {other, 8, 3},
                                             {8, 1, 3},
                                             {5, 4, 8},
                                             {1, 8, 4}});
  return build(soup).mesh;
}

TEST(JoinLayersAt, ThirdCornersBecomeOneAndTheirFacesGo) {
  const TriMesh mesh = two_fans(9);
  const HalfedgeHandle crease = mesh.find_halfedge(vertex(0), vertex(1));
  const auto join = join_layers_at(mesh, crease);
  ASSERT_TRUE(join);
  EXPECT_EQ(join->merged, vertex(2));
  EXPECT_EQ(join->kept, vertex(3));
  ASSERT_EQ(join->layers.size(), 1U);
  EXPECT_EQ(join->layers[0][0], mesh.opposite_face_handle(crease));
  EXPECT_EQ(join->layers[0][1], mesh.face_handle(crease));
  EXPECT_EQ(join->changed.size(), 4U);
}

TEST(JoinLayersAt, VerticesWithAnEdgeToTheSameOneAreNotJoined) {
  const TriMesh mesh = two_fans(5);
  ASSERT_TRUE(mesh.find_halfedge(vertex(2), vertex(5)).is_valid());
  ASSERT_TRUE(mesh.find_halfedge(vertex(3), vertex(5)).is_valid());
  EXPECT_FALSE(join_layers_at(mesh, mesh.find_halfedge(vertex(0), vertex(1))));
}

TEST(JoinLayersAt, NeighboursAreNotJoined) {
  const TriMesh mesh = build(shapes::tetrahedron()).mesh;
  for (const auto h : mesh.halfedges()) EXPECT_FALSE(join_layers_at(mesh, h));
}

}  // namespace
}  // namespace meshalyzer
