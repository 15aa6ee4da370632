#include "meshalyzer/repair/driver/internal/changed_places.h"

#include "support/shapes.h"
#include "unit/repair/driver/tracked_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

using Operations = std::vector<Index>;

TEST(ChangedPlaces, FindsOperationsByTheFaceOfTheInput) {
  TrackedMesh mesh = track_mesh(shapes::cube());
  // Two faces made of face 3, and a patch.
  add_face(mesh, {0, 1, 2}, 3);
  add_face(mesh, {1, 2, 3}, 3);
  add_face(mesh, {2, 3, 4}, kNoIndex);
  const AffectedElements affected{.faces_before = {{3, 5}, {4, 2}, {12, 1}, {13, 5}, {14, 0}},
                                  .faces_after = {},
                                  .vertices = {}};
  const ChangedPlaces places(mesh, affected);
  EXPECT_EQ(places.on(3), (Operations{1, 5}));
  EXPECT_EQ(places.on(4), (Operations{2}));
  EXPECT_EQ(places.on(5), Operations{});
}

TEST(ChangedPlaces, FindsOperationsByBoxesAsBruteForceDoes) {
  std::mt19937 random(7);
  const TrackedMesh mesh = track_mesh(shapes::tangle(200));
  AffectedElements affected;
  for (Index face = 0; face < 200; face += 3) {
    affected.faces_before.push_back({face, face % 17});
    if (face % 2 == 0) affected.faces_before.push_back({face, 17 + face % 5});
  }
  const ChangedPlaces places(mesh, affected);
  std::uniform_real_distribution<double> coordinate(-0.2, 1.2);
  for (int i = 0; i < 200; ++i) {
    const Vec3 corner(coordinate(random), coordinate(random), coordinate(random));
    const Box3 box(corner, corner + Vec3(0.2, 0.1, 0.05));
    std::set<Index> expected;
    for (const AffectedElement& entry : affected.faces_before) {
      Box3 of_face;
      for (const Vec3& p : corners_of(mesh.soup, entry.key)) of_face.extend(p);
      if (of_face.intersects(box)) expected.insert(entry.operation);
    }
    EXPECT_EQ(places.near(box), Operations(expected.begin(), expected.end()));
  }
}

}  // namespace
}  // namespace meshalyzer
