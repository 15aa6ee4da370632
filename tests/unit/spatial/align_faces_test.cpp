#include "meshalyzer/spatial/align_faces.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

constexpr auto kEqual = [](Index a, Index b) { return a == b; };

TEST(AlignFaces, CommonVerticesComeFirstInTheSameOrder) {
  const auto [p, q, n_common] = align_faces(Triangle{7, 1, 2}, Triangle{2, 3, 1}, kEqual);
  EXPECT_EQ(n_common, 2U);
  EXPECT_EQ(p[0], q[0]);
  EXPECT_EQ(p[1], q[1]);
  EXPECT_EQ(p[2], 7U);
  EXPECT_EQ(q[2], 3U);
}

TEST(AlignFaces, FacesWithNothingInCommonStayAsTheyAre) {
  const auto [p, q, n_common] = align_faces(Triangle{0, 1, 2}, Triangle{3, 4, 5}, kEqual);
  EXPECT_EQ(n_common, 0U);
  EXPECT_EQ(p, (Triangle{0, 1, 2}));
  EXPECT_EQ(q, (Triangle{3, 4, 5}));
}

TEST(AlignFaces, FaceAndItsReverseHaveAllInCommon) {
  const auto [p, q, n_common] = align_faces(Triangle{0, 1, 2}, Triangle{2, 1, 0}, kEqual);
  EXPECT_EQ(n_common, 3U);
  EXPECT_EQ(p, q);
}

}  // namespace
}  // namespace meshalyzer
