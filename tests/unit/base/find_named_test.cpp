#include "meshalyzer/base/find_named.h"

#include <gtest/gtest.h>

#include <array>

namespace meshalyzer {
namespace {

enum class Side { Left, Right };

std::string_view name_of_side(Side side) {
  return side == Side::Left ? "left" : "right";
}

TEST(FindNamed, ValueIsFoundByItsName) {
  EXPECT_EQ(find_named(std::array{Side::Left, Side::Right}, "right", name_of_side), Side::Right);
}

TEST(FindNamed, NameOfNoValueFindsNothing) {
  EXPECT_EQ(find_named(std::array{Side::Left, Side::Right}, "up", name_of_side), std::nullopt);
  EXPECT_EQ(find_named(std::array{Side::Left}, "right", name_of_side), std::nullopt);
}

}  // namespace
}  // namespace meshalyzer
