#include "meshalyzer/spatial/winding_number.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/box_tree.h"
#include "meshalyzer/spatial/tree_width.h"
#include "meshalyzer/spatial/unit_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// A node is approximated as a whole beyond this many of its radii. The error falls with the square
/// of this: 0.04 of a sphere at 2, 0.009 at 4.
constexpr double kFar = 4.0;
/// A point at this distance of a triangle is on it if the size of the mesh is about 1. The distance
/// is at least a multiple of the spacing of the coordinates.
constexpr double kOnTriangle = 0x1p-40;
constexpr double kOnTriangleRoundings = 8.0;
/// Bounds the rounding error of a determinant, relative to the lengths of its rows.
constexpr double kRounding = 0x1p-48;
/// Beyond the square root of this distance all triangles count as a point.
constexpr double kTooFar = 1e60;
/// Products of smaller numbers might underflow.
constexpr double kSmallProduct = 1e-100;

/// The shares of all directions from a point that meet triangles, added up.
///
/// Half the solid angle of a triangle is the argument of a complex number (van Oosterom and
/// Strackee 1983, "The solid angle of a plane triangle"), and a product of numbers has the sum of
/// their arguments. So the arctangent, which costs more than all else, is taken of many at once.
class ShareOfDirections {
 public:
  /// Adds the share of a triangle; it is positive where its normal points away.
  ///
  /// @param near  A point within this distance is on the triangle.
  void add(const Corners& t, const Vec3& point, double near) {
    const Vec3 a = t[0] - point;
    const Vec3 b = t[1] - point;
    const Vec3 c = t[2] - point;
    const double x = a.norm();
    const double y = b.norm();
    const double z = c.norm();
    const double sine = a.dot(b.cross(c));
    // The sum is ordered so that exchanging b and c changes no bit.
    const double cosine = x * (y * z) + (a.dot(b) * z + a.dot(c) * y) + b.dot(c) * x;
    if (cosine > 0.0) {
      multiply(cosine, sine);
    } else if (std::abs(sine) > near * normal_of(t).norm() + kRounding * (x * (y * z))) {
      sum_ += std::atan2(sine, cosine);
    }
  }

  [[nodiscard]] double total() const {
    return (sum_ + std::atan2(imaginary_, real_)) / (2.0 * std::numbers::pi);
  }

 private:
  /// Both factors have arguments below a right angle, so that their sum does not wrap round.
  void multiply(double cosine, double sine) {
    const double real = real_ * cosine - imaginary_ * sine;
    const double imaginary = real_ * sine + imaginary_ * cosine;
    if (real > kSmallProduct) {
      real_ = real;
      imaginary_ = imaginary;
    } else {
      sum_ += std::atan2(imaginary_, real_);
      real_ = cosine;
      imaginary_ = sine;
    }
  }

  /// The arguments of the triangles that are not in the product.
  double sum_ = 0.0;
  double real_ = 1.0;
  double imaginary_ = 0.0;
};

/// The far field of some triangles: the first two terms of the multipole expansion about their
/// centre.
struct Dipole {
  Vec3 centre = Vec3::Zero();
  /// The square of the distance from which the expansion is accurate enough.
  double far_squared = 0.0;
  /// The sum of the area vectors.
  Vec3 area = Vec3::Zero();
  /// The sum of the products of offset and area vector, symmetric: its diagonal, and twice the rest
  /// (yz, zx, xy).
  Vec3 diagonal = Vec3::Zero();
  Vec3 mixed = Vec3::Zero();

  /// Returns the share of directions of all the triangles together.
  [[nodiscard]] double share_from(const Vec3& to_centre, double distance_squared) const {
    const Vec3& r = to_centre;
    const double inverse = 1.0 / distance_squared;
    const double second = diagonal.dot(r.cwiseProduct(r)) +
                          mixed.dot(Vec3(r.y() * r.z(), r.z() * r.x(), r.x() * r.y()));
    const double sum = area.dot(r) + diagonal.sum() - 3.0 * second * inverse;
    return sum * inverse * std::sqrt(inverse) / (4.0 * std::numbers::pi);
  }
};

Vec3 middle_of(const Corners& t) {
  return (t[0] + (t[1] + t[2])) / 3.0;
}

Dipole dipole_of(std::span<const Corners> triangles) {
  Dipole dipole;
  double weight = 0.0;
  for (const Corners& t : triangles) {
    const Vec3 area = normal_of(t) / 2.0;
    dipole.area += area;
    dipole.centre += area.norm() * middle_of(t);
    weight += area.norm();
  }
  if (!(weight > 0.0)) {
    return {};
  }
  dipole.centre /= weight;
  double radius_squared = 0.0;
  for (const Corners& t : triangles) {
    const Vec3 n = normal_of(t) / 2.0;
    const Vec3 d = middle_of(t) - dipole.centre;
    dipole.diagonal += d.cwiseProduct(n);
    dipole.mixed += Vec3(d.y() * n.z() + d.z() * n.y(), d.z() * n.x() + d.x() * n.z(),
                         d.x() * n.y() + d.y() * n.x());
    for (const Vec3& p : t) {
      radius_squared = std::max(radius_squared, (p - dipole.centre).squaredNorm());
    }
  }
  dipole.far_squared = kFar * kFar * radius_squared;
  return dipole;
}

std::vector<Box3> boxes_of(std::span<const Corners> triangles) {
  std::vector<Box3> boxes(triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const Vec3& p : triangles[i]) {
      boxes[i].extend(p);
    }
  }
  return boxes;
}

}  // namespace

/// An implicit, complete tree with eight children per node over the triangles, ordered along a
/// space-filling curve.
struct WindingNumbers::Tree {
  explicit Tree(std::vector<Corners> soup)
      : scale(soup), near(std::max(kOnTriangle, kOnTriangleRoundings * scale.rounding())) {
    for (Corners& t : soup) {
      for (Vec3& p : t) {
        p = scale(p);
      }
    }
    const std::vector<Index> order = order_in_space(boxes_of(soup));
    triangles.reserve(order.size());
    for (const Index i : order) triangles.push_back(soup[i]);
    soup = {};
    for (std::size_t length = kTreeWidth; !triangles.empty(); length *= kTreeWidth) {
      levels.push_back(level_of(length));
      if (levels.back().size() <= kTreeWidth) {
        break;
      }
    }
  }

  /// Returns the dipoles of `length` triangles each.
  [[nodiscard]] std::vector<Dipole> level_of(std::size_t length) const {
    std::vector<Dipole> level(n_chunks(triangles.size(), length));
    const std::size_t nodes_per_task = std::max<std::size_t>(1, kChunkLength / length);
    parallel_chunks(level.size(), nodes_per_task, [&](Chunk chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const std::size_t end = std::min(length * (i + 1), triangles.size());
        level[i] = dipole_of(std::span(triangles).subspan(length * i, end - length * i));
      }
    });
    return level;
  }

  [[nodiscard]] double share(std::size_t level, std::size_t i, const Vec3& point) const {
    const Dipole& dipole = levels[level][i];
    const Vec3 to_centre = dipole.centre - point;
    const double distance_squared = to_centre.squaredNorm();
    if (distance_squared > dipole.far_squared) {
      return dipole.share_from(to_centre, distance_squared);
    }
    const std::size_t n_below = level == 0 ? triangles.size() : levels[level - 1].size();
    const std::size_t end = std::min(kTreeWidth * (i + 1), n_below);
    if (level == 0) {
      ShareOfDirections directions;
      for (std::size_t t = kTreeWidth * i; t < end; ++t) directions.add(triangles[t], point, near);
      return directions.total();
    }
    double sum = 0.0;
    for (std::size_t child = kTreeWidth * i; child < end; ++child) {
      sum += share(level - 1, child, point);
    }
    return sum;
  }

  UnitScale scale;
  double near;
  std::vector<Corners> triangles;
  /// Level 0 has the dipoles of eight triangles each; each other level those of eight nodes below.
  std::vector<std::vector<Dipole>> levels;
};

WindingNumbers::WindingNumbers(std::vector<Corners> triangles)
    : tree_(std::make_unique<Tree>(std::move(triangles))) {}

WindingNumbers::~WindingNumbers() = default;

double WindingNumbers::at(const Vec3& point) const {
  const Vec3 p = tree_->scale(point);
  if (tree_->levels.empty() || !(p.squaredNorm() < kTooFar)) {
    return 0.0;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < tree_->levels.back().size(); ++i) {
    sum += tree_->share(tree_->levels.size() - 1, i, p);
  }
  return sum;
}

}  // namespace meshalyzer
