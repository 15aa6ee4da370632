#include "meshalyzer/spatial/faces_meeting_box.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/mesh/build.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

Vec3 random_point(std::mt19937& random) {
  return {below(random, 4001) / 1000.0 - 2.0, below(random, 4001) / 1000.0 - 2.0,
          below(random, 4001) / 1000.0 - 2.0};
}

TEST(FindFacesMeeting, FindsAllFacesWhoseBoxesMeetABoxAndHardlyAnyOthers) {
  const Soup soup = shapes::icosphere(3);
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  std::mt19937 random(7);
  std::size_t n_meeting = 0;
  std::size_t n_found = 0;
  for (int i = 0; i < 300; ++i) {
    Box3 box(random_point(random));
    if (i % 3 != 0) box.extend(random_point(random));
    std::vector<Index> found = find_faces_meeting(tree, box);
    std::sort(found.begin(), found.end());
    n_found += found.size();
    for (Index f = 0; f < soup.n_faces(); ++f) {
      if (!box_of(corners_of(soup, f)).intersects(box)) continue;
      ++n_meeting;
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), f));
    }
  }
  EXPECT_GT(n_meeting, 10'000U);
  EXPECT_LE(n_found, n_meeting + n_meeting / 100);
}

TEST(FindFacesMeeting, EmptyTreeHasNone) {
  const Soup soup;
  const CutMesh cut = build(soup);
  EXPECT_TRUE(find_faces_meeting(FaceTree(cut), Box3(Vec3::Zero())).empty());
}

}  // namespace
}  // namespace meshalyzer
