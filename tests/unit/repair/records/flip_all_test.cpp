#include "meshalyzer/repair/passes.h"
#include "support/run_pass.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

/// Once: flipping again would flip back.
PassResult flip(const Soup& soup) {
  const TrackedMesh tracked = track_mesh(soup);
  const PreparedMesh mesh(tracked.soup);
  const Tolerances tolerances;
  const RepairLimits limits;
  return flip_all({tracked.soup, tracked, mesh, tolerances, limits});
}

Soup flipped(const Soup& soup) {
  return apply_edits(track_mesh(soup), flip(soup).edits).soup;
}

TEST(FlipAll, EveryFaceIsTurned) {
  const Soup soup = shapes::torus(3.0, 1.0, 5, 4);
  const Soup turned = flipped(soup);
  ASSERT_EQ(turned.n_faces(), soup.n_faces());
  EXPECT_TRUE(same_bits(turned.positions, soup.positions));
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    EXPECT_EQ(turned.triangles[f], (Triangle{t[0], t[2], t[1]}));
  }
}

TEST(FlipAll, TwiceIsNothing) {
  const Soup soup = shapes::merged(shapes::cube(), shapes::moebius_strip(5));
  EXPECT_TRUE(same_soup(flipped(flipped(soup)), soup));
}

TEST(FlipAll, EmptyMeshIsLeft) {
  EXPECT_TRUE(flip(Soup{}).edits.empty());
}

TEST(FlipAll, FaceWithAMissingCornerIsLeft) {
  Soup soup = shapes::tetrahedron();
  soup.triangles[2][0] = kNoIndex;
  soup.missing.push_back({2, 0, 77});
  const Soup turned = flipped(soup);
  EXPECT_EQ(turned.triangles[2], soup.triangles[2]);
  EXPECT_NE(turned.triangles[0], soup.triangles[0]);
}

TEST(FlipAll, NormalsAreTurnedWithTheFaces) {
  Soup soup = shapes::tetrahedron();
  soup.format = Format::Ply;
  for (Index v = 0; v < 4; ++v) soup.normals.push_back(Vec3(1, v, 2).normalized());
  soup.corner_normals = soup.triangles;
  const Soup turned = flipped(soup);
  for (Index f = 0; f < 4; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(turned.normals[turned.corner_normals[f][k]], -soup.normals[turned.triangles[f][k]]);
    }
  }
}

TEST(FlipAll, EachOfSeveralNormalsAtAVertexIsTurned) {
  Soup soup = shapes::tetrahedron();
  soup.format = Format::Obj;
  soup.normals = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), Vec3(1, 1, 1)};
  soup.corner_normals = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  const Soup turned = flipped(soup);
  for (Index f = 0; f < 4; ++f) {
    for (const Index normal : turned.corner_normals[f]) {
      EXPECT_EQ(turned.normals[normal], -soup.normals[f]);
    }
  }
}

}  // namespace
}  // namespace meshalyzer
