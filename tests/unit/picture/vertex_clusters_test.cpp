#include "meshalyzer/picture/internal/vertex_clusters.h"

#include "meshalyzer/base/parallel.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

TriangleList decimated(const Soup& soup, std::size_t max_faces,
                       const std::vector<std::uint8_t>& pinned = {}) {
  std::vector<Index> faces = drawable_faces(soup);
  const DrawingFrame frame(box_of(soup, faces));
  return cluster_vertices(soup, frame, std::move(faces), {max_faces, pinned});
}

TEST(ClusterVertices, FewFacesStayAsTheyAre) {
  const Soup soup = shapes::icosphere(2);
  const TriangleList list = decimated(soup, 320);
  EXPECT_EQ(list.triangles, soup.triangles);
  EXPECT_EQ(list.faces.back(), 319U);
}

TEST(ClusterVertices, ManyFacesBecomeAboutAsManyAsAllowed) {
  for (const Soup& soup :
       {shapes::icosphere(6), shapes::grid(200, 200), shapes::torus(5, 1, 300, 100),
        shapes::scaled(shapes::grid(200, 200), 1e-320),
        shapes::scaled(shapes::icosphere(6), 0x1p1020)}) {
    const std::size_t n = decimated(soup, 5000).triangles.size();
    EXPECT_LE(n, 5000U);
    EXPECT_GE(n, 2500U);
  }
}

TEST(ClusterVertices, CornersAreVerticesOfTheFileAndFacesAreFaces) {
  const Soup soup = shapes::icosphere(5);
  const TriangleList list = decimated(soup, 1000);
  std::set<Triangle> seen;
  for (std::size_t i = 0; i < list.triangles.size(); ++i) {
    Triangle t = list.triangles[i];
    const Triangle& from = soup.triangles[list.faces[i]];
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_LT(t[k], soup.n_vertices());
      // Within the diagonal of a cell: some 20 a side of a box of size 2.
      EXPECT_LT((soup.positions[t[k]] - soup.positions[from[k]]).norm(), 0.4);
    }
    std::sort(t.begin(), t.end());
    EXPECT_TRUE(t[0] != t[1] && t[1] != t[2]);
    EXPECT_TRUE(seen.insert(t).second) << "twice";
  }
  EXPECT_TRUE(std::is_sorted(list.faces.begin(), list.faces.end()));
}

TEST(ClusterVertices, VertexNearestToTheMiddleStandsForItsCell) {
  // Three clumps, small and far apart, so that each falls into a cell; the last vertex of each is
  // nearest to its middle.
  std::vector<Vec3> positions;
  for (const Vec3& clump : {Vec3(0, 0, 0), Vec3(100, 0, 0), Vec3(0, 100, 0)}) {
    for (const double step : {-1e-6, 1e-6, 1e-7}) {
      positions.push_back(clump + Vec3(step, step, step));
    }
  }
  // Faces from clump to clump, all of which become the same, and within the clumps.
  std::vector<Triangle> triangles;
  for (Index i = 0; i < 3; ++i) triangles.push_back({i, 3 + i, 6 + i});
  for (Index i = 0; i < 3; ++i) triangles.push_back({3 + (i + 1) % 3, i, 6 + i});
  for (Index i = 0; i < 3; ++i) triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  const TriangleList list = decimated(shapes::make(positions, triangles), 6);
  ASSERT_EQ(list.triangles.size(), 1U);
  EXPECT_EQ(list.triangles[0], (Triangle{2, 5, 8}));
  EXPECT_EQ(list.faces[0], 0U);
}

TEST(ClusterVertices, PinnedVerticesStay) {
  const Soup soup = shapes::grid(100, 100);
  std::vector<std::uint8_t> pinned(soup.n_vertices(), 0);
  // The faces of the first row of squares have these.
  for (std::size_t v = 0; v <= 100; ++v) pinned[v] = 1;
  const TriangleList list = decimated(soup, 2000, pinned);
  EXPECT_LE(list.triangles.size(), 2000U);
  std::set<Index> used;
  for (const Triangle& t : list.triangles) used.insert(t.begin(), t.end());
  for (Index v = 0; v <= 100; ++v) EXPECT_TRUE(used.contains(v)) << v;
}

TEST(ClusterVertices, PinsAreGivenUpWhereTheyAreTooMany) {
  const Soup soup = shapes::grid(100, 100);
  const std::vector<std::uint8_t> pinned(soup.n_vertices(), 1);
  const std::size_t n = decimated(soup, 1000, pinned).triangles.size();
  EXPECT_LE(n, 1000U);
  EXPECT_GE(n, 500U);
}

TEST(ClusterVertices, OnePlaceLeavesNothing) {
  Soup soup = shapes::grid(20, 20);
  for (Vec3& p : soup.positions) p = Vec3(1, 2, 3);
  EXPECT_TRUE(decimated(soup, 100).triangles.empty());
}

TEST(ClusterVertices, NumberOfThreadsDoesNotMatter) {
  const Soup soup = shapes::shuffled_faces(shapes::icosphere(6), 3);
  const TriangleList wanted = decimated(soup, 3000);
  const ThreadLimit one(1);
  const TriangleList found = decimated(soup, 3000);
  EXPECT_EQ(found.triangles, wanted.triangles);
  EXPECT_EQ(found.faces, wanted.faces);
}

}  // namespace
}  // namespace meshalyzer
