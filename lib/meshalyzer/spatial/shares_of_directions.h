#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/two_vectors.h"

#include <cmath>
#include <numbers>

namespace meshalyzer {

/// The shares of all directions from each of two points that meet triangles, added up.
///
/// Half the solid angle of a triangle is the argument of a complex number (van Oosterom and
/// Strackee 1983, "The solid angle of a plane triangle"), and a product of numbers has the sum of
/// their arguments. So the arctangent, which costs more than all else, is taken of many at once.
/// Queries take a quarter longer where the compiler does not inline add() and
/// FarField::share_from().
class SharesOfDirections {
 public:
  /// Adds the share of a triangle; it is positive where its normal points away.
  ///
  /// @param near  A point within this distance is on the triangle.
  [[gnu::always_inline]] void add(const Corners& t, const TwoVectors& points, double near) {
    const TwoVectors a = points.from(t[0]);
    const TwoVectors b = points.from(t[1]);
    const TwoVectors c = points.from(t[2]);
    const Two x = a.dot(a).sqrt();
    const Two y = b.dot(b).sqrt();
    const Two z = c.dot(c).sqrt();
    const Two sine = a.dot(b.cross(c));
    // The sum is ordered so that exchanging b and c changes no bit.
    const Two cosine = x * (y * z) + (a.dot(b) * z + a.dot(c) * y) + b.dot(c) * x;
    if (cosine.minCoeff() > 0.0 && multiply(cosine, sine)) return;
    for (Eigen::Index i = 0; i < 2; ++i) {
      const double rounding = kRounding * (x[i] * (y[i] * z[i]));
      // Behind the plane of the corners the argument is large, unless the point is on the triangle.
      if (cosine[i] > 0.0 || std::abs(sine[i]) > near * normal_of(t).norm() + rounding) {
        sum_[i] += std::atan2(sine[i], cosine[i]);
      }
    }
  }

  [[nodiscard]] Two total() const { return (sum_ + arguments()) / (2.0 * std::numbers::pi); }

 private:
  /// Bounds the rounding error of a determinant, relative to the lengths of its rows.
  static constexpr double kRounding = 0x1p-48;
  /// Products of smaller numbers might underflow, and of larger ones overflow.
  static constexpr double kSmallProduct = 1e-100;
  static constexpr double kLargeProduct = 1e100;

  /// Multiplies both products by numbers whose arguments are below a right angle, as those of the
  /// products are, so that sums of arguments do not wrap round. Once a product would become too
  /// large, too small, or of a larger argument, its argument is added to the sum.
  ///
  /// @return  Whether the numbers are in the products now.
  bool multiply(const Two& cosine, const Two& sine) {
    const Two real = real_ * cosine - imaginary_ * sine;
    const Two imaginary = real_ * sine + imaginary_ * cosine;
    if (real.minCoeff() > kSmallProduct && (real + imaginary.abs()).maxCoeff() < kLargeProduct) {
      real_ = real;
      imaginary_ = imaginary;
      return true;
    }
    sum_ += arguments();
    real_ = Two::Ones();
    imaginary_ = Two::Zero();
    return false;
  }

  [[nodiscard]] Two arguments() const {
    return {std::atan2(imaginary_[0], real_[0]), std::atan2(imaginary_[1], real_[1])};
  }

  /// The arguments of the triangles that are not in the product.
  Two sum_ = Two::Zero();
  Two real_ = Two::Ones();
  Two imaginary_ = Two::Zero();
};

}  // namespace meshalyzer
