#include "meshalyzer/base/nearest_name.h"

#include <gtest/gtest.h>

#include <array>
#include <string_view>

namespace meshalyzer {
namespace {

constexpr std::array<std::string_view, 4> kNames{"check", "hole", "flipped", "orphan-vertex"};

TEST(NearestName, IsOneLetterAway) {
  EXPECT_EQ(nearest_name("chek", kNames), "check");
  EXPECT_EQ(nearest_name("holes", kNames), "hole");
  EXPECT_EQ(nearest_name("hule", kNames), "hole");
}

TEST(NearestName, ExchangeOfTwoNeighboursIsOneEdit) {
  EXPECT_EQ(nearest_name("chekc", kNames), "check");
  EXPECT_EQ(nearest_name("ohle", kNames), "hole");
}

TEST(NearestName, ExchangeBesideAnotherEditIsTwo) {
  EXPECT_EQ(nearest_name("filpedd", kNames), "");  // a third edit: one p is missing
  EXPECT_EQ(nearest_name("filppedd", kNames), "flipped");
}

TEST(NearestName, NoneIsCloseEnough) {
  EXPECT_EQ(nearest_name("elho", kNames), "");
  EXPECT_EQ(nearest_name("", kNames), "");
}

TEST(NearestName, FirstOfEquallyCloseOnes) {
  constexpr std::array<std::string_view, 2> kTwo{"cat", "car"};
  EXPECT_EQ(nearest_name("cap", kTwo), "cat");
}

TEST(DidYouMean, NamesTheNearestOrNothing) {
  EXPECT_EQ(did_you_mean("chekc", kNames), "; did you mean 'check'?");
  EXPECT_EQ(did_you_mean("mesh.obj", kNames), "");
}

}  // namespace
}  // namespace meshalyzer
