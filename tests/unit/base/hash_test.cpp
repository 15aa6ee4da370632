#include "meshalyzer/base/hash.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(HashPosition, ZerosOfBothSignsHaveOneHash) {
  EXPECT_EQ(hash_position({0.0, 1.0, -0.0}), hash_position({-0.0, 1.0, 0.0}));
}

TEST(HashPosition, OrderOfCoordinatesCounts) {
  EXPECT_NE(hash_position({1.0, 2.0, 3.0}), hash_position({3.0, 2.0, 1.0}));
}

}  // namespace
}  // namespace meshalyzer
