#include "meshalyzer/defects/finders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace meshalyzer {
namespace {

using Edges = std::vector<std::array<Index, 2>>;

DefectList non_manifold_in(const Soup& soup) {
  return find_non_manifold(PreparedMesh(soup));
}

TEST(FindNonManifold, ManifoldMeshesHaveNone) {
  EXPECT_TRUE(non_manifold_in({}).empty());
  EXPECT_TRUE(non_manifold_in(shapes::cube()).empty());
  EXPECT_TRUE(non_manifold_in(shapes::open_cube()).empty());
  EXPECT_TRUE(non_manifold_in(shapes::pillow()).empty());
}

TEST(FindNonManifold, MeshThatIsNotOrientableIsManifold) {
  EXPECT_TRUE(non_manifold_in(shapes::moebius_strip(5)).empty());
  EXPECT_TRUE(non_manifold_in(shapes::projective_plane()).empty());
}

TEST(FindNonManifold, EdgeOfManyFacesIsNamedWithThemAndItsEndsAreNot) {
  const Soup soup = shapes::fan_of_three();
  const DefectList defects = non_manifold_in(soup);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].code, DefectCode::NonManifold);
  EXPECT_EQ(defects[0].edges, (Edges{{0, 1}}));
  EXPECT_TRUE(defects[0].vertices.empty());
  EXPECT_EQ(defects[0].faces, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(defects[0].value, 3.0);
  ASSERT_EQ(defects[0].positions.size(), 1U);
  EXPECT_EQ(defects[0].positions[0], (soup.positions[0] + soup.positions[1]) / 2);
}

TEST(FindNonManifold, PinchedVertexIsNamedWithItsFans) {
  const Soup soup = shapes::two_tetrahedra_sharing_vertex();
  std::vector<Index> faces;
  Index pinch = kNoIndex;
  for (Index v = 0; v < soup.n_vertices(); ++v) {
    if (soup.positions[v] == Vec3::Zero()) pinch = v;
  }
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (t[0] == pinch || t[1] == pinch || t[2] == pinch) faces.push_back(f);
  }
  const DefectList defects = non_manifold_in(soup);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].vertices, std::vector<Index>{pinch});
  EXPECT_TRUE(defects[0].edges.empty());
  EXPECT_EQ(defects[0].faces, faces);
  EXPECT_EQ(defects[0].value, 2.0);
  EXPECT_EQ(defects[0].positions, std::vector<Vec3>{Vec3::Zero()});
}

TEST(FindNonManifold, FanThatIsCutAtAFlippedEdgeIsOneFan) {
  // Vertex 0 has a fan of two faces, one of them turned over, and a face of its own apart. Both
  // faces cross their edge away from vertex 0, or both towards it.
  const std::vector<Vec3> positions{Vec3(0, 0, 0), Vec3(1, 0, 0),  Vec3(1, 1, 0),
                                    Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(-1, -1, 0)};
  for (const Triangle& second : {Triangle{0, 3, 2}, Triangle{0, 1, 3}}) {
    const DefectList defects =
        non_manifold_in(shapes::make(positions, {{0, 1, 2}, second, {0, 4, 5}}));
    ASSERT_EQ(defects.size(), 1U);
    EXPECT_EQ(defects[0].vertices, std::vector<Index>{0});
    EXPECT_EQ(defects[0].value, 2.0);
    EXPECT_EQ(defects[0].faces, (std::vector<Index>{0, 1, 2}));
  }
}

TEST(FindNonManifold, EveryEdgeOfADoubledWallIsListedOnce) {
  const DefectList defects = non_manifold_in(shapes::two_tetrahedra_sharing_face());
  ASSERT_EQ(defects.size(), 3U);
  for (const Defect& defect : defects) {
    EXPECT_EQ(defect.value, 4.0);
    EXPECT_EQ(defect.faces.size(), 4U);
  }
}

TEST(FindNonManifold, EdgesAndVerticesAreInOrderOfTheirLowestVertex) {
  // Two fans of three on the edges (0, 1) and (9, 10), and a pinch at vertex 5 between them.
  const Soup soup = shapes::merged(
      shapes::merged(shapes::fan_of_three(), shapes::two_tetrahedra_sharing_vertex()),
      shapes::fan_of_three());
  const DefectList defects = non_manifold_in(soup);
  ASSERT_EQ(defects.size(), 3U);
  EXPECT_EQ(defects[0].edges, (Edges{{0, 1}}));
  EXPECT_EQ(defects[1].vertices, std::vector<Index>{5});
  EXPECT_EQ(defects[2].edges, (Edges{{12, 13}}));
}

}  // namespace
}  // namespace meshalyzer
