#include "meshalyzer/base/require.h"

#include "meshalyzer/base/error.h"
#include "support/constants.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace meshalyzer {
namespace {

constexpr double kLeast = std::numeric_limits<double>::denorm_min();

/// Returns why a check refuses its value; empty if it does not.
std::string refusal(const std::function<void()>& check) {
  try {
    check();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return {};
}

TEST(Require, NumbersMayBeInfiniteButNotNan) {
  for (const double number : {-kInfinity, -1.0, 0.0, kInfinity}) {
    EXPECT_NO_THROW(require_number("the limit", number));
  }
  EXPECT_EQ(refusal([] { require_number("the limit", kNaN); }),
            "the limit is nan, which is no number");
}

TEST(Require, LengthsAreFiniteAndNotNegative) {
  for (const double length : {0.0, -0.0, kLeast, 1e308}) {
    EXPECT_NO_THROW(require_length("the tolerance", length));
  }
  for (const double no_length : {-kLeast, kInfinity, -kInfinity, kNaN}) {
    EXPECT_THROW(require_length("the tolerance", no_length), InvalidArgument);
  }
  EXPECT_EQ(refusal([] { require_length("the tolerance", -1.0); }),
            "the tolerance is -1, which is no length");
}

TEST(Require, PositiveLengthsAreNotZero) {
  EXPECT_NO_THROW(require_positive_length("the spacing", kLeast));
  for (const double other : {0.0, -1.0, kInfinity, kNaN}) {
    EXPECT_THROW(require_positive_length("the spacing", other), InvalidArgument);
  }
}

TEST(Require, SecondsMayBeInfiniteButNotNegative) {
  for (const double seconds : {0.0, 1.0, kInfinity}) {
    EXPECT_NO_THROW(require_seconds("the time limit", seconds));
  }
  EXPECT_THROW(require_seconds("the time limit", -kLeast), InvalidArgument);
  EXPECT_THROW(require_seconds("the time limit", kNaN), InvalidArgument);
}

TEST(Require, AnglesAreWithinZeroAndTheLargest) {
  EXPECT_NO_THROW(require_angle("the cone", 0.0, 90.0));
  EXPECT_NO_THROW(require_angle("the cone", 90.0, 90.0));
  EXPECT_THROW(require_angle("the cone", kNaN, 90.0), InvalidArgument);
  EXPECT_EQ(refusal([] { require_angle("the cone", 91.0, 90.0); }),
            "the cone is 91 degrees, which is not within 0 and 90");
}

TEST(Require, AbsentOptionsAreNoFault) {
  EXPECT_NO_THROW(require_number("it", std::nullopt));
  EXPECT_NO_THROW(require_length("it", std::nullopt));
  EXPECT_NO_THROW(require_seconds("it", std::nullopt));
  EXPECT_NO_THROW(require_angle("it", std::nullopt, 90.0));
}

TEST(Require, PointsAreFinite) {
  EXPECT_NO_THROW(require_point("the point", Vec3(1e308, -1e308, 0.0)));
  EXPECT_EQ(refusal([] { require_point("the point", Vec3(1.0, kNaN, -kInfinity)); }),
            "the point is 1 nan -inf, which is no point");
}

TEST(Require, FunctionsAreNotNull) {
  EXPECT_NO_THROW(require_function("the rule", std::function<void()>([] {})));
  EXPECT_EQ(refusal([] { require_function("the rule", std::function<void()>()); }),
            "the rule is null");
}

}  // namespace
}  // namespace meshalyzer
