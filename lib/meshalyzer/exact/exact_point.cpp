#include "meshalyzer/exact/exact_point.h"

#include "meshalyzer/exact/balanced_matrix.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

using Exact = CGAL::Mpzf;

// Between these exponents a quotient of two doubles neither overflows nor loses bits.
constexpr double kSmallestSafe = 0x1p-400;
constexpr double kLargestSafe = 0x1p+400;

bool is_safe(double x) {
  return std::abs(x) > kSmallestSafe && std::abs(x) < kLargestSafe;
}

/// Returns a number that may be beyond the range of doubles, not zero, with the relative error of
/// its conversion into a double.
WideNumber to_wide(Exact x) {
  int exponent = 0;
  const auto rescale = [&](int by) {
    x = x * Exact(std::ldexp(1.0, -by));
    exponent += by;
  };
  while (!std::isfinite(x.to_double())) rescale(1000);
  while (std::abs(x.to_double()) < kSmallestSafe) rescale(-1000);
  WideNumber result = wide(x.to_double());
  result.exponent += exponent;
  return result;
}

/// Divides a by b with a relative error below 2^-50, or an absolute one of a few of the smallest
/// doubles. The result is zero only where a is, and finite.
double quotient(const Exact& a, const Exact& b) {
  if (a.is_zero()) return 0.0;
  const double x = a.to_double();
  const double y = b.to_double();
  if (is_safe(x) && is_safe(y)) return x / y;
  const WideNumber p = to_wide(a);
  const WideNumber q = to_wide(b);
  const double size =
      std::ldexp(std::abs(p.mantissa) / std::abs(q.mantissa), p.exponent - q.exponent);
  using Limits = std::numeric_limits<double>;
  return std::copysign(std::clamp(size, Limits::denorm_min(), Limits::max()),
                       static_cast<double>(a.sign() * b.sign()));
}

/// A rounded number and the distance to the exact one.
struct Rounded {
  double value = 0.0;
  double rest = 0.0;
};

bool is_odd(double x) {
  return (std::bit_cast<std::uint64_t>(x) & 1U) != 0;
}

/// Tells whether a / b lies nearer to `next` than to its neighbour `value`, or half-way and `next`
/// is the even one. `towards` is the sign of next - value.
bool is_nearer(const Exact& a, const Exact& b, std::pair<double, double> value_next, Sign towards) {
  const auto [value, next] = value_next;
  const Sign beyond = (a + a - (Exact(value) + Exact(next)) * b).sign() * towards;
  return beyond > 0 || (beyond == 0 && is_odd(value));
}

/// Returns the double nearest to a / b, b > 0. The search begins near it and steps from one double
/// to the next.
Rounded nearest(const Exact& a, const Exact& b) {
  Rounded result{.value = quotient(a, b)};
  for (;;) {
    result.rest = quotient(a - Exact(result.value) * b, b);
    if (result.rest == 0.0) return result;
    const Sign towards = result.rest > 0.0 ? 1 : -1;
    const double next =
        std::nextafter(result.value, towards * std::numeric_limits<double>::infinity());
    if (!std::isfinite(next)) return result;
    // The rest is known so well that only the tie in the middle needs an exact test.
    const double step = std::abs(next - result.value);
    if (std::abs(result.rest) < 0.499 * step && step > kSmallestSafe) return result;
    if (!is_nearer(a, b, {result.value, next}, towards)) return result;
    result.value = next;
  }
}

/// A number, and a bound of the error in it.
struct Approximation {
  double value = 0.0;
  double error = 0.0;
};

// The bound covers two roundings of the parts and one of their sum; a rest is off by less than
// 2^-50 of itself, or by a few of the smallest doubles, of which the bound of a tiny rest would
// keep nothing.
Approximation difference(const ExactPoint& p, const ExactPoint& q, Eigen::Index k) {
  const double coarse = p.rounded[k] - q.rounded[k];
  const double fine = p.rest[k] - q.rest[k];
  return {coarse + fine, 0x1.1p-52 * (std::abs(coarse) + std::abs(fine)) +
                             0x1.1p-50 * (std::abs(p.rest[k]) + std::abs(q.rest[k])) + 0x1p-1068};
}

Sign compare_coordinate(const ExactPoint& a, const ExactPoint& b, Eigen::Index k) {
  if (a.rounded[k] != b.rounded[k]) return a.rounded[k] < b.rounded[k] ? -1 : 1;
  const double x = a.rest[k];
  const double y = b.rest[k];
  if (x == 0.0 && y == 0.0) return 0;
  if (std::abs(x - y) > 0x1p-48 * (std::abs(x) + std::abs(y)) && std::abs(x - y) > kSmallestSafe) {
    return x < y ? -1 : 1;
  }
  const auto i = static_cast<std::size_t>(k);
  return (a.numerator[i] * b.denominator - b.numerator[i] * a.denominator).sign();
}

Sign exact_orient2d(std::size_t i, std::size_t j, const std::array<const ExactPoint*, 3>& p) {
  const auto minor = [&](const ExactPoint& q, const ExactPoint& r) {
    return q.numerator[i] * r.numerator[j] - q.numerator[j] * r.numerator[i];
  };
  return (p[0]->denominator * minor(*p[1], *p[2]) + p[1]->denominator * minor(*p[2], *p[0]) +
          p[2]->denominator * minor(*p[0], *p[1]))
      .sign();
}

/// Rows and columns of differences of exact points.
using Differences = std::array<std::array<Approximation, 2>, 2>;

/// A determinant, and a bound of its error.
Approximation determinant(const Differences& m) {
  const auto& [ux, uy] = m[0];
  const auto& [vx, vy] = m[1];
  const double first = std::abs(ux.value * vy.value);
  const double second = std::abs(uy.value * vx.value);
  const double bound =
      1.01 * (ux.error * (std::abs(vy.value) + vy.error) + std::abs(ux.value) * vy.error +
              uy.error * (std::abs(vx.value) + vx.error) + std::abs(uy.value) * vx.error +
              0x1p-52 * (first + second));
  return {ux.value * vy.value - uy.value * vx.value, bound};
}

/// Multiplies rows and columns with powers of two so that the determinant neither overflows nor
/// loses more than kLostInBalance, and keeps its sign.
Differences balanced(Differences m) {
  WideMatrix<2> sizes;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) sizes[i][j] = wide(std::abs(m[i][j].value) + m[i][j].error);
  }
  const BalancedMatrix<2> balance_of_sizes = balance(sizes);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const int power = -(balance_of_sizes.row[i] + balance_of_sizes.column[j]);
      m[i][j].value = std::ldexp(m[i][j].value, power);
      m[i][j].error = std::ldexp(m[i][j].error, power);
    }
  }
  return m;
}

/// Returns the sign of (b - a) x (c - a) in the coordinates i and j, where floating point is sure
/// of it.
std::optional<Sign> filtered(Eigen::Index i, Eigen::Index j,
                             const std::array<const ExactPoint*, 3>& p) {
  const Differences m{{{difference(*p[1], *p[0], i), difference(*p[1], *p[0], j)},
                       {difference(*p[2], *p[0], i), difference(*p[2], *p[0], j)}}};
  Approximation d = determinant(m);
  if (!(d.error > kSmallestSafe && d.error < kLargestSafe)) {
    d = determinant(balanced(m));
    d.error += kLostInBalance;
  }
  // Where a difference overflows, the bound is not a number.
  if (!(std::abs(d.value) > d.error)) return std::nullopt;
  return d.value > 0.0 ? 1 : -1;
}

/// Returns the sign of (b - a) x (c - a) . (d - a), where floating point is sure of it.
std::optional<Sign> filtered_orient3d(const Vec3& a, const Vec3& b, const Vec3& c,
                                      const ExactPoint& d) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  // The rest is off by 2^-50 of itself, and no coordinate of w is smaller than its rest, but zero.
  const Vec3 w = (d.rounded - a) + d.rest;
  const auto largest = [&](Eigen::Index k) {
    return std::max({std::abs(u[k]), std::abs(v[k]), std::abs(w[k])});
  };
  const double x = largest(0);
  const double y = largest(1);
  const double z = largest(2);
  const double determinant = w.dot(u.cross(v));
  // Each of six products of three is off by less than 2^-49 of itself: 2^-50 for w, and seven
  // roundings of 2^-53.
  const double bound = 6.0 * 0x1p-49 * x * y * z;
  const bool is_safe_range = std::min({x, y, z}) > 0x1p-130 && std::max({x, y, z}) < 0x1p+130;
  if (!is_safe_range || std::abs(determinant) <= bound) return std::nullopt;
  return determinant > 0.0 ? 1 : -1;
}

Sign exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const ExactPoint& d) {
  std::array<Exact, 3> u;
  std::array<Exact, 3> v;
  std::array<Exact, 3> w;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    u[k] = Exact(b[i]) - Exact(a[i]);
    v[k] = Exact(c[i]) - Exact(a[i]);
    w[k] = d.numerator[k] - Exact(a[i]) * d.denominator;
  }
  return (w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
          w[2] * (u[0] * v[1] - u[1] * v[0]))
      .sign();
}

}  // namespace

ExactPoint exact_point(const Vec3& point) {
  ExactPoint result;
  for (Eigen::Index k = 0; k < 3; ++k) {
    result.numerator[static_cast<std::size_t>(k)] = Exact(point[k]);
  }
  result.denominator = Exact(1);
  result.rounded = point;
  return result;
}

ExactPoint exact_point(std::array<Exact, 3> numerator, Exact denominator) {
  ExactPoint result{.numerator = std::move(numerator), .denominator = std::move(denominator)};
  if (result.denominator.sign() < 0) {
    for (Exact& x : result.numerator) x = -x;
    result.denominator = -result.denominator;
  }
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Rounded rounded =
        nearest(result.numerator[static_cast<std::size_t>(k)], result.denominator);
    result.rounded[k] = rounded.value;
    result.rest[k] = rounded.rest;
  }
  return result;
}

Sign compare_lexicographically(const ExactPoint& a, const ExactPoint& b) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (const Sign sign = compare_coordinate(a, b, k)) return sign;
  }
  return 0;
}

Sign orient2d(Axis dropped, const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  if (a.is_rounded() && b.is_rounded() && c.is_rounded()) {
    return orient2d(dropped, a.rounded, b.rounded, c.rounded);
  }
  const auto k = static_cast<std::size_t>(dropped);
  const std::size_t i = (k + 1) % 3;
  const std::size_t j = (k + 2) % 3;
  const std::array<const ExactPoint*, 3> points{&a, &b, &c};
  if (const auto sure =
          filtered(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j), points)) {
    return *sure;
  }
  return exact_orient2d(i, j, points);
}

Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const ExactPoint& d) {
  if (d.is_rounded()) return orient3d(a, b, c, d.rounded);
  const std::optional<Sign> sure = filtered_orient3d(a, b, c, d);
  return sure ? *sure : exact_orient3d(a, b, c, d);
}

}  // namespace meshalyzer
