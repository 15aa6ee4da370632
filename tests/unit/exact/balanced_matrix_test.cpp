#include "meshalyzer/exact/balanced_matrix.h"

#include "support/rational_figures.h"
#include "unit/exact/random_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace meshalyzer {
namespace {

using test::Rational;

constexpr int kRounds = 300;

/// Multiplies powers that doubles can hold.
Rational power_of_two(int exponent) {
  Rational result(1);
  while (exponent != 0) {
    const int step = std::clamp(exponent, -1000, 1000);
    result = result * Rational(std::ldexp(1.0, step));
    exponent -= step;
  }
  return result;
}

Rational value_of(const WideNumber& x) {
  return Rational(x.mantissa) * power_of_two(x.exponent);
}

WideMatrix<3> differences(const std::array<Vec3, 4>& points) {
  WideMatrix<3> matrix;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto k = static_cast<Eigen::Index>(j);
      matrix[i][j] = wide_difference(points[i + 1][k], points[0][k]);
    }
  }
  return matrix;
}

TEST(WideDifference, IsNearTheDifferenceOfRationalsAlsoWhereDoublesOverflow) {
  for (const Cloud cloud : kClouds) {
    RandomPoints points(11);
    for (int round = 0; round < kRounds; ++round) {
      const Vec3 p = points.next(cloud);
      const Vec3 q = points.next(cloud);
      const Rational exact = Rational(p.x()) - Rational(q.x());
      const Rational error = CGAL::abs(value_of(wide_difference(p.x(), q.x())) - exact);
      ASSERT_TRUE(error <= CGAL::abs(exact) * Rational(0x1p-53)) << p.x() << " - " << q.x();
    }
  }
  constexpr double kMost = std::numeric_limits<double>::max();
  const WideNumber twice = wide_difference(kMost, -kMost);
  EXPECT_TRUE(value_of(twice) == Rational(2) * Rational(kMost));
}

TEST(Balance, MultipliesRowsAndColumnsWithPowersOfTwoOnly) {
  for (const Cloud cloud : kClouds) {
    RandomPoints points(12);
    for (int round = 0; round < kRounds; ++round) {
      const WideMatrix<3> matrix = differences(
          {points.next(cloud), points.next(cloud), points.next(cloud), points.next(cloud)});
      const BalancedMatrix<3> balanced = balance(matrix);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          const Rational wanted =
              value_of(matrix[i][j]) * power_of_two(-balanced.row[i] - balanced.column[j]);
          const Rational error = CGAL::abs(Rational(balanced.entries[i][j]) - wanted);
          ASSERT_TRUE(error < Rational(std::numeric_limits<double>::denorm_min()));
        }
      }
    }
  }
}

TEST(Balance, LargestOfEachColumnIsBetweenHalfAndOne) {
  for (const Cloud cloud : kClouds) {
    RandomPoints points(13);
    for (int round = 0; round < kRounds; ++round) {
      const BalancedMatrix<3> balanced = balance(differences(
          {points.next(cloud), points.next(cloud), points.next(cloud), points.next(cloud)}));
      for (std::size_t j = 0; j < 3; ++j) {
        double largest = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
          largest = std::max(largest, std::abs(balanced.entries[i][j]));
        }
        ASSERT_TRUE(largest == 0.0 || (largest >= 0.5 && largest <= 1.0)) << largest;
      }
    }
  }
}

}  // namespace
}  // namespace meshalyzer
