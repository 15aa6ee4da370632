#include "meshalyzer/mesh/finite_positions.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/mesh/build.h"
#include "support/constants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(FinitePositions, OneCoordinateThatIsNotFiniteIsEnough) {
  EXPECT_TRUE(has_finite_positions(Soup{}));
  EXPECT_NO_THROW(require_finite_positions(shapes::cube(1e308)));
  EXPECT_NO_THROW(require_finite_positions(build(shapes::cube(1e308)).mesh));
  for (const double wrong : {kNaN, kInfinity, -kInfinity}) {
    Soup soup = shapes::cube();
    soup.positions[7].y() = wrong;
    EXPECT_FALSE(has_finite_positions(soup)) << wrong;
    EXPECT_THROW(require_finite_positions(soup), InvalidArgument) << wrong;
    EXPECT_THROW(require_finite_positions(build(soup).mesh), InvalidArgument) << wrong;
  }
}

}  // namespace
}  // namespace meshalyzer
