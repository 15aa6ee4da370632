#include "meshalyzer/exact/predicates.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/exact/balanced_matrix.h"
#include "meshalyzer/exact/plane_view.h"

#include <CGAL/Mpzf.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

// Static error bounds for determinants whose entries are differences of doubles, with u = 2^-53.
// Every product of the expansion undergoes 4 roundings in two dimensions (two differences, a
// product, a sum) and 8 in three (three differences, two products, a difference, two sums); there
// are 2 and 6 products, each at most the product of the largest entries of each coordinate. So the
// error is at most 2 * 4u and 6 * 8u of that; the factors below also cover the rounding of the
// bound itself.
constexpr double kUnit = 0x1p-53;
constexpr double kBound2 = 2 * 4 * kUnit * 1.01;
constexpr double kBound3 = 6 * 8 * kUnit * 1.01;
constexpr double kBoundOfProduct = 8 * kUnit * 1.01;

// Within these magnitudes no product of two or three entries, nor the error bound, overflows or
// loses bits to underflow.
constexpr double kSmall = 0x1p-320;
constexpr double kLarge = 0x1p+330;

double largest(double a, double b) {
  return std::max(std::abs(a), std::abs(b));
}
double largest(double a, double b, double c) {
  return std::max(largest(a, b), std::abs(c));
}

/// Returns the sign of a determinant with rounding errors where it is certain, else nothing.
/// @param scales_min, scales_max  The smallest and the largest of the largest entries of each
///     coordinate.
std::optional<Sign> filtered(double determinant, double bound, double scales_min,
                             double scales_max) {
  if (scales_min == 0.0) {
    return 0;  // all points have one coordinate in common: a difference that is zero is exactly
               // zero
  }
  if (scales_min < kSmall || !(scales_max < kLarge)) {
    return std::nullopt;
  }
  if (determinant > bound) {
    return 1;
  }
  if (determinant < -bound) {
    return -1;
  }
  return std::nullopt;
}

/// Tells whether an entry is zero, which is exact, or within the magnitudes above.
bool is_usual(double entry) {
  return entry == 0.0 || (std::abs(entry) > kSmall && std::abs(entry) < kLarge);
}

template <std::size_t N>
using Matrix = std::array<std::array<double, N>, N>;

/// Returns the sign of a determinant of differences where it is certain. The bound is the sum of
/// the products, of each of which the error is at most 8u.
std::optional<Sign> sign_of_products(const Matrix<3>& rows) {
  double determinant = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [i, j] = std::pair{(k + 1) % 3, (k + 2) % 3};
    const double plus = rows[0][i] * rows[1][j];
    const double minus = rows[0][j] * rows[1][i];
    determinant += rows[2][k] * (plus - minus);
    sum += std::abs(rows[2][k]) * (std::abs(plus) + std::abs(minus));
  }
  if (std::abs(determinant) <= kBoundOfProduct * sum + kLostInBalance) return std::nullopt;
  return determinant > 0.0 ? 1 : -1;
}

std::optional<Sign> sign_of_products(const Matrix<2>& rows) {
  const double plus = rows[0][0] * rows[1][1];
  const double minus = rows[0][1] * rows[1][0];
  const double sum = std::abs(plus) + std::abs(minus);
  if (std::abs(plus - minus) <= kBoundOfProduct * sum + kLostInBalance) return std::nullopt;
  return plus > minus ? 1 : -1;
}

/// Returns the sign of the determinant of the differences between some points and the first one,
/// where it is certain; for points of any and of very different magnitudes, with more work than a
/// filter of known magnitudes.
///
/// The differences are to the point with the smallest coordinates, as nothing would be left of the
/// others in differences from a point that is far out.
template <std::size_t N>
std::optional<Sign> sure_of_products(std::array<const Vec3*, N + 1> points,
                                     const std::array<Eigen::Index, N>& coordinates) {
  const auto magnitude = [&](const Vec3* point) {
    double largest = 0.0;
    for (const Eigen::Index k : coordinates) largest = std::max(largest, std::abs((*point)[k]));
    return largest;
  };
  const auto smallest =
      std::min_element(points.begin(), points.end(),
                       [&](const Vec3* p, const Vec3* q) { return magnitude(p) < magnitude(q); });
  const Sign exchanged = smallest == points.begin() ? 1 : -1;
  std::iter_swap(points.begin(), smallest);

  Matrix<N> rows;
  bool is_safe = true;
  for (std::size_t i = 0; i < N; ++i) {
    bool is_same = true;
    for (std::size_t j = 0; j < N; ++j) {
      const Eigen::Index k = coordinates[j];
      rows[i][j] = (*points[i + 1])[k] - (*points[0])[k];
      is_safe = is_safe && is_usual(rows[i][j]);
      is_same = is_same && rows[i][j] == 0.0;
    }
    if (is_same) return 0;  // a difference that is zero is exactly zero
  }
  if (!is_safe) {
    WideMatrix<N> differences;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        const Eigen::Index k = coordinates[j];
        differences[i][j] = wide_difference((*points[i + 1])[k], (*points[0])[k]);
      }
    }
    rows = balance(differences).entries;
  }
  const std::optional<Sign> sure = sign_of_products(rows);
  if (!sure) return std::nullopt;
  return exchanged * *sure;
}

using Exact = CGAL::Mpzf;
using ExactVec3 = std::array<Exact, 3>;

ExactVec3 exact_difference(const Vec3& p, const Vec3& q) {
  return {Exact(p.x()) - Exact(q.x()), Exact(p.y()) - Exact(q.y()), Exact(p.z()) - Exact(q.z())};
}

Sign sign_of(const Exact& value) {
  return static_cast<Sign>(value.sign());
}

Sign exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const ExactVec3 u = exact_difference(b, a);
  const ExactVec3 v = exact_difference(c, a);
  const ExactVec3 w = exact_difference(d, a);
  return sign_of(w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
                 w[2] * (u[0] * v[1] - u[1] * v[0]));
}

struct Plane2 {
  Eigen::Index i;
  Eigen::Index j;
};

Plane2 kept(Axis dropped) {
  const auto k = static_cast<Eigen::Index>(dropped);
  return {(k + 1) % 3, (k + 2) % 3};
}

}  // namespace

std::optional<Sign> orient3d_if_sure(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 w = d - a;
  const double x = largest(u.x(), v.x(), w.x());
  const double y = largest(u.y(), v.y(), w.y());
  const double z = largest(u.z(), v.z(), w.z());
  const double determinant = w.x() * (u.y() * v.z() - u.z() * v.y()) +
                             w.y() * (u.z() * v.x() - u.x() * v.z()) +
                             w.z() * (u.x() * v.y() - u.y() * v.x());
  return filtered(determinant, kBound3 * x * y * z, std::min({x, y, z}), std::max({x, y, z}));
}

Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  if (const std::optional<Sign> sure = orient3d_if_sure(a, b, c, d)) return *sure;
  if (const auto sure = sure_of_products<3>({&a, &b, &c, &d}, {0, 1, 2})) return *sure;
  return exact_orient3d(a, b, c, d);
}

std::optional<Sign> orient2d_if_sure(Axis dropped, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto [i, j] = kept(dropped);
  const double ux = b[i] - a[i];
  const double uy = b[j] - a[j];
  const double vx = c[i] - a[i];
  const double vy = c[j] - a[j];
  const double x = largest(ux, vx);
  const double y = largest(uy, vy);
  return filtered(ux * vy - uy * vx, kBound2 * x * y, std::min(x, y), std::max(x, y));
}

Sign orient2d(Axis dropped, const Vec3& a, const Vec3& b, const Vec3& c) {
  if (const std::optional<Sign> sure = orient2d_if_sure(dropped, a, b, c)) {
    return *sure;
  }
  const auto [i, j] = kept(dropped);
  if (const auto sure = sure_of_products<2>({&a, &b, &c}, {i, j})) return *sure;
  const Exact ux = Exact(b[i]) - Exact(a[i]);
  const Exact uy = Exact(b[j]) - Exact(a[j]);
  const Exact vx = Exact(c[i]) - Exact(a[i]);
  const Exact vy = Exact(c[j]) - Exact(a[j]);
  return sign_of(ux * vy - uy * vx);
}

bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  return orient2d(Axis::X, a, b, c) == 0 && orient2d(Axis::Y, a, b, c) == 0 &&
         orient2d(Axis::Z, a, b, c) == 0;
}

std::optional<Axis> projection_axis(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto best = static_cast<int>(longest_axis(normal_of(a, b, c)));
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<Axis>((best + i) % 3);
    if (orient2d(axis, a, b, c) != 0) {
      return axis;
    }
  }
  return std::nullopt;
}

}  // namespace meshalyzer
