#include "meshalyzer/repair/edits/internal/closed_fan.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

TEST(ClosedFan, FacesAreInTheOrderInWhichTheySurroundTheVertex) {
  const std::vector<Triangle> faces{{0, 3, 1}, {1, 2, 5}, {1, 2, 0}, {3, 0, 2}};
  EXPECT_EQ(closed_fan(faces, 0), (std::vector<Index>{2, 3, 0}));
}

TEST(ClosedFan, OpenTurnedAndSeveralFansAreNone) {
  EXPECT_FALSE(closed_fan(std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}, 0));
  EXPECT_FALSE(closed_fan(std::vector<Triangle>{{0, 1, 2}, {0, 3, 2}, {0, 3, 1}}, 0));
  EXPECT_FALSE(closed_fan(std::vector<Triangle>{{0, 1, 2}, {0, 2, 1}}, 0));
  const std::vector<Triangle> two{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}};
  EXPECT_FALSE(closed_fan(two, 0));
}

}  // namespace
}  // namespace meshalyzer
