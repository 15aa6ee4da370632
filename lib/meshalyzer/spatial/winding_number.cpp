#include "meshalyzer/spatial/winding_number.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/closing_triangles.h"
#include "meshalyzer/spatial/order_by_size.h"
#include "meshalyzer/spatial/ray_windings.h"
#include "meshalyzer/spatial/tree_width.h"
#include "meshalyzer/spatial/unit_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// A node is approximated as a whole beyond this many of its radii. The error falls with the cube
/// of this: it is below 0.003 of a winding number for real surfaces at 2, and 0.015 at 1.5.
constexpr double kFarFine = 2.0;
constexpr double kFarCoarse = 1.5;
/// A point at this distance of a triangle is on it if the size of the mesh is about 1. The distance
/// is at least a multiple of the spacing of the coordinates.
constexpr double kOnTriangle = 0x1p-40;
constexpr double kOnTriangleRoundings = 8.0;
/// Bounds the rounding error of a determinant, relative to the lengths of its rows.
constexpr double kRounding = 0x1p-48;
/// Rays are used where the triangles are at least this many times as many as those that close them.
constexpr std::size_t kWorthRays = 2;
/// Beyond the square root of this distance all triangles count as a point.
constexpr double kTooFar = 1e60;
/// Products of smaller numbers might underflow, and of larger ones overflow.
constexpr double kSmallProduct = 1e-100;
constexpr double kLargeProduct = 1e100;

/// One number for each of two points.
using Two = Eigen::Array2d;

/// Two points, or the offsets of one place from two points, which processors compute at once.
struct TwoVectors {
  TwoVectors(const Vec3& first, const Vec3& second)
      : x(first.x(), second.x()), y(first.y(), second.y()), z(first.z(), second.z()) {}
  TwoVectors(const Two& x_values, const Two& y_values, const Two& z_values)
      : x(x_values), y(y_values), z(z_values) {}

  [[nodiscard]] TwoVectors from(const Vec3& place) const {
    return {place.x() - x, place.y() - y, place.z() - z};
  }
  [[nodiscard]] Two dot(const TwoVectors& other) const {
    return x * other.x + y * other.y + z * other.z;
  }
  [[nodiscard]] Two dot(const Vec3& other) const {
    return x * other.x() + y * other.y() + z * other.z();
  }
  [[nodiscard]] TwoVectors cross(const TwoVectors& other) const {
    return {y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x};
  }

  Two x;
  Two y;
  Two z;
};

/// The shares of all directions from each of two points that meet triangles, added up.
///
/// Half the solid angle of a triangle is the argument of a complex number (van Oosterom and
/// Strackee 1983, "The solid angle of a plane triangle"), and a product of numbers has the sum of
/// their arguments. So the arctangent, which costs more than all else, is taken of many at once.
class SharesOfDirections {
 public:
  /// Adds the share of a triangle; it is positive where its normal points away.
  ///
  /// @param near  A point within this distance is on the triangle.
  void add(const Corners& t, const TwoVectors& points, double near) {
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

/// The far field of some triangles: the first three terms of the multipole expansion about their
/// centre. With r from the point to the centre and d from the centre to a place on a triangle, the
/// flux of (r + d) / |r + d|^3 through all triangles is expanded in d. The derivatives of r / |r|^3
/// are symmetric and traceless, so that only such parts of the moments count.
struct FarField {
  Vec3 centre = Vec3::Zero();
  /// The square of the distance from which the expansion is accurate enough.
  double far_squared = 0.0;
  /// The sum of the area vectors.
  Vec3 area = Vec3::Zero();
  /// The integral of the products of offset and area vector, as the coefficients of a quadratic
  /// form: of xx, yy, zz, and of yz, zx, xy.
  Vec3 squares = Vec3::Zero();
  Vec3 mixed = Vec3::Zero();
  /// The integral of the products of two offsets and the area vector, as the coefficients of a
  /// cubic form: of xxx, yyy, zzz; of xyy, yzz, zxx; of xzz, yxx, zyy; of xyz.
  Vec3 cubes = Vec3::Zero();
  Vec3 with_next = Vec3::Zero();
  Vec3 with_last = Vec3::Zero();
  double of_all = 0.0;

  /// Adds a triangle with corners at offsets from the centre.
  ///
  /// @param n  The area vector.
  void add(const Corners& d, const Vec3& n) {
    const Vec3 sum = d[0] + (d[1] + d[2]);
    const Vec3 mean = sum / 3.0;
    squares += mean.cwiseProduct(n);
    mixed += Vec3(mean.y() * n.z() + mean.z() * n.y(), mean.z() * n.x() + mean.x() * n.z(),
                  mean.x() * n.y() + mean.y() * n.x());
    // The means over the triangle of products of two coordinates.
    const auto product = [&](int i, int j) {
      const double of_corners = d[0][i] * d[0][j] + (d[1][i] * d[1][j] + d[2][i] * d[2][j]);
      return (of_corners + sum[i] * sum[j]) / 12.0;
    };
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      cubes[i] += product(i, i) * n[i];
      with_next[i] += product(j, j) * n[i] + 2.0 * product(i, j) * n[j];
      with_last[i] += product(k, k) * n[i] + 2.0 * product(i, k) * n[k];
      of_all += 2.0 * product(j, k) * n[i];
    }
  }

  /// Makes both forms harmonic, which changes nothing but makes their traces zero.
  void remove_traces() {
    squares.array() -= squares.sum() / 3.0;
    const Vec3 trace = (3.0 * cubes + with_next + with_last) / 5.0;
    cubes -= trace;
    with_next -= trace;
    with_last -= trace;
  }

  /// Returns the shares of directions of all the triangles together, as seen from two points.
  ///
  /// @param r  The offsets from the points to the centre.
  [[nodiscard]] Two share_from(const TwoVectors& r, const Two& distance_squared) const {
    const Two inverse = 1.0 / distance_squared;
    const TwoVectors square(r.x * r.x, r.y * r.y, r.z * r.z);
    const TwoVectors product(r.y * r.z, r.z * r.x, r.x * r.y);
    const Two second = square.dot(squares) + product.dot(mixed);
    const TwoVectors factor(
        cubes.x() * square.x + with_next.x() * square.y + with_last.x() * square.z,
        cubes.y() * square.y + with_next.y() * square.z + with_last.y() * square.x,
        cubes.z() * square.z + with_next.z() * square.x + with_last.z() * square.y);
    const Two third = factor.dot(r) + of_all * (r.x * product.x);
    const Two sum = r.dot(area) + (7.5 * third * inverse - 3.0 * second) * inverse;
    return sum * inverse * inverse.sqrt() / (4.0 * std::numbers::pi);
  }
};

Vec3 middle_of(const Corners& t) {
  return (t[0] + (t[1] + t[2])) / 3.0;
}

/// @param far  The field is used beyond this many radii.
FarField far_field_of(std::span<const Corners> triangles, double far) {
  FarField field;
  double weight = 0.0;
  for (const Corners& t : triangles) {
    const Vec3 area = normal_of(t) / 2.0;
    field.area += area;
    field.centre += area.norm() * middle_of(t);
    weight += area.norm();
  }
  if (!(weight > 0.0)) {
    return {};
  }
  field.centre /= weight;
  double radius_squared = 0.0;
  for (const Corners& t : triangles) {
    const Corners offsets{t[0] - field.centre, t[1] - field.centre, t[2] - field.centre};
    field.add(offsets, normal_of(t) / 2.0);
    for (const Vec3& d : offsets) radius_squared = std::max(radius_squared, d.squaredNorm());
  }
  field.remove_traces();
  field.far_squared = far * far * radius_squared;
  return field;
}

/// Winding numbers by the far fields of groups of triangles. It is an implicit, complete tree with
/// eight children per node over the triangles, ordered by size and along a space-filling curve.
class FarFieldTree {
 public:
  /// @param triangles  Triangles with coordinates of about -1 ... 1.
  /// @param near       A point within this distance of a triangle is on it.
  /// @param far        A node is approximated as a whole beyond this many of its radii.
  FarFieldTree(std::span<const Corners> triangles, double near, double far)
      : near_(near), far_(far) {
    triangles_.reserve(triangles.size());
    for (const Index i : order_by_size(triangles)) triangles_.push_back(triangles[i]);
    for (std::size_t length = kTreeWidth; !triangles_.empty(); length *= kTreeWidth) {
      levels_.push_back(level_of(length));
      if (levels_.back().size() <= kTreeWidth) {
        break;
      }
    }
  }

  [[nodiscard]] Two at(const TwoVectors& points) const {
    if (levels_.empty()) return Two::Zero();
    SharesOfDirections near_triangles;
    Two sum = Two::Zero();
    for (std::size_t i = 0; i < levels_.back().size(); ++i) {
      sum += share(levels_.size() - 1, i, points, near_triangles);
    }
    return sum + near_triangles.total();
  }

 private:
  /// Returns the far fields of `length` triangles each.
  [[nodiscard]] std::vector<FarField> level_of(std::size_t length) const {
    std::vector<FarField> level(n_chunks(triangles_.size(), length));
    const std::size_t nodes_per_task = std::max<std::size_t>(1, kChunkLength / length);
    parallel_chunks(level.size(), nodes_per_task, [&](Chunk chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const std::size_t end = std::min(length * (i + 1), triangles_.size());
        level[i] = far_field_of(std::span(triangles_).subspan(length * i, end - length * i), far_);
      }
    });
    return level;
  }

  /// Returns the shares of what is far from two points, and adds the triangles that are not.
  [[nodiscard]] Two share(std::size_t level, std::size_t i, const TwoVectors& points,
                          SharesOfDirections& near_triangles) const {
    const FarField& field = levels_[level][i];
    const TwoVectors to_centre = points.from(field.centre);
    const Two distance_squared = to_centre.dot(to_centre);
    if (distance_squared.minCoeff() > field.far_squared) {
      return field.share_from(to_centre, distance_squared);
    }
    const std::size_t n_below = level == 0 ? triangles_.size() : levels_[level - 1].size();
    const std::size_t end = std::min(kTreeWidth * (i + 1), n_below);
    Two sum = Two::Zero();
    for (std::size_t child = kTreeWidth * i; child < end; ++child) {
      if (level == 0) {
        near_triangles.add(triangles_[child], points, near_);
      } else {
        sum += share(level - 1, child, points, near_triangles);
      }
    }
    return sum;
  }

  double near_;
  double far_;
  std::vector<Corners> triangles_;
  /// Level 0 has the far fields of eight triangles each; each other level those of eight nodes
  /// below.
  std::vector<std::vector<FarField>> levels_;
};

/// Winding numbers by the crossings of rays with the triangles and others that close them, less the
/// numbers of those others: exact but for the last, and the faster the smaller the boundary is.
class ClosedByTriangles {
 public:
  /// @param closing  The triangles that close the others.
  ClosedByTriangles(std::span<const Corners> triangles, std::span<const Corners> closing,
                    double near, double far)
      : all_(joined(triangles, closing), near), closing_(closing, near, far) {}

  /// Returns the numbers at two points; nothing where a ray gives no answer.
  [[nodiscard]] std::optional<Two> at(const Vec3& first, const Vec3& second) const {
    const auto of_all = all_.at_both(first, second);
    if (!of_all) return std::nullopt;
    return Two((*of_all)[0], (*of_all)[1]) - closing_.at({first, second});
  }

 private:
  static std::vector<Corners> joined(std::span<const Corners> first,
                                     std::span<const Corners> second) {
    std::vector<Corners> all(first.begin(), first.end());
    all.insert(all.end(), second.begin(), second.end());
    return all;
  }

  RayWindings all_;
  FarFieldTree closing_;
};

}  // namespace

/// The triangles, prepared for both ways to compute their winding numbers.
struct WindingNumbers::Prepared {
  /// @param triangles  Triangles that were scaled.
  Prepared(const UnitScale& unit_scale, std::span<const Corners> triangles,
           ExpectedQueries expected, double far)
      : scale(unit_scale),
        near(std::max(kOnTriangle, kOnTriangleRoundings * scale.rounding())),
        by_far_fields(triangles, near, far) {
    if (expected == ExpectedQueries::Few) return;
    const std::vector<Corners> closing = closing_triangles(triangles);
    if (kWorthRays * closing.size() > triangles.size()) return;
    by_rays.emplace(triangles, closing, near, far);
  }

  [[nodiscard]] Two at(const Vec3& first, const Vec3& second) const {
    if (by_rays) {
      if (const auto found = by_rays->at(first, second)) return *found;
    }
    return by_far_fields.at({first, second});
  }

  UnitScale scale;
  double near;
  FarFieldTree by_far_fields;
  std::optional<ClosedByTriangles> by_rays;
};

WindingNumbers::WindingNumbers(std::vector<Corners> triangles, ExpectedQueries expected,
                               WindingAccuracy accuracy) {
  const UnitScale scale(triangles);
  for (Corners& t : triangles) {
    for (Vec3& p : t) p = scale(p);
  }
  const double far = accuracy == WindingAccuracy::Fine ? kFarFine : kFarCoarse;
  prepared_ = std::make_unique<Prepared>(scale, triangles, expected, far);
}

WindingNumbers::WindingNumbers(WindingNumbers&&) noexcept = default;
WindingNumbers::~WindingNumbers() = default;

double WindingNumbers::at(const Vec3& point) const {
  return at_both(point, point)[0];
}

std::array<double, 2> WindingNumbers::at_both(const Vec3& first, const Vec3& second) const {
  const Vec3 a = prepared_->scale(first);
  const Vec3 b = prepared_->scale(second);
  const bool is_a_near = a.squaredNorm() < kTooFar;
  const bool is_b_near = b.squaredNorm() < kTooFar;
  if (!is_a_near && !is_b_near) return {0.0, 0.0};
  // A point that is too far gets the answer of the other one, which is dropped.
  const Two found = prepared_->at(is_a_near ? a : b, is_b_near ? b : a);
  return {is_a_near ? found[0] : 0.0, is_b_near ? found[1] : 0.0};
}

}  // namespace meshalyzer
