#include "meshalyzer/repair/weld/internal/halve_reach.h"

#include <gtest/gtest.h>

#include <limits>

namespace meshalyzer {
namespace {

TEST(HalveUntil, ReachThatFitsStays) {
  EXPECT_EQ(halve_until(3.0, [](double) { return true; }), 3.0);
}

TEST(HalveUntil, ReachIsTheFirstOfAllHalvesThatFits) {
  for (const double limit : {2.9, 1.5, 1.4, 1e-3, 1e-30, 1e-300}) {
    double expected = 3.0;
    while (expected > limit) expected /= 2;
    EXPECT_EQ(halve_until(3.0, [&](double reach) { return reach <= limit; }), expected);
  }
}

TEST(HalveUntil, LeastReachIsReturnedWhereNoneFits) {
  EXPECT_EQ(halve_until(3.0, [](double) { return false; }),
            std::numeric_limits<double>::denorm_min());
}

TEST(HalveUntil, LastReachFoundToFitIsTheResult) {
  double last = 0.0;
  const double result = halve_until(1e35, [&](double reach) {
    if (reach <= 1.0) last = reach;
    return reach <= 1.0;
  });
  EXPECT_EQ(last, result);
}

}  // namespace
}  // namespace meshalyzer
