#include "meshalyzer/spatial/ray_windings.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/order_by_size.h"
#include "meshalyzer/spatial/tree_width.h"

#include <Eigen/Core>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

/// Bounds the rounding error of determinants, relative to the sum of the magnitudes of their terms.
constexpr double kRoundingOfRays = 0x1p-48;

/// Returns the rotation that turns the direction of all rays to x: about half a degree, so that
/// rays are parallel to no face of a part that was drawn along the axes, and the boxes of such
/// faces stay thin.
Eigen::Matrix3d ray_frame() {
  const Vec3 along = Vec3(1.0, 0.0075487766624669, 0.0056984029099805).normalized();
  const Vec3 across = Vec3::UnitZ().cross(along).normalized();
  Eigen::Matrix3d frame;
  frame.row(0) = along;
  frame.row(1) = across;
  frame.row(2) = along.cross(across);
  return frame;
}

const Eigen::Matrix3d& frame() {
  static const Eigen::Matrix3d made = ray_frame();
  return made;
}

std::array<float, 3> to_floats(const Vec3& p) {
  // Conversion is monotone, so that boxes that share a point do so afterwards.
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/// Tells on which side of the line a b a point lies, in the projection along x: 1, -1, or 0 if
/// rounding might decide.
int sure_side(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double first = (b.y() - a.y()) * (p.z() - a.z());
  const double second = (b.z() - a.z()) * (p.y() - a.y());
  const double side = first - second;
  if (std::abs(side) <= kRoundingOfRays * (std::abs(first) + std::abs(second))) return 0;
  return side > 0.0 ? 1 : -1;
}

}  // namespace

/// Adds up the crossings of the rays from two points, which visit the same nodes if they are near
/// each other.
class RayWindings::TwoRays {
 public:
  TwoRays(const RayWindings& all, const Vec3& first, const Vec3& second)
      : all_(all),
        starts_{first, second},
        n_rays_(first == second ? 1 : 2),
        runs_up_(first.x() > 0.0),
        box_{to_floats(first.cwiseMin(second)), to_floats(first.cwiseMax(second))} {
    constexpr float kEnd = std::numeric_limits<float>::infinity();
    (runs_up_ ? box_.high : box_.low)[0] = runs_up_ ? kEnd : -kEnd;
  }

  std::optional<std::array<int, 2>> follow() {
    if (!all_.levels_.empty() && !descend(all_.levels_.size() - 1, 0)) return std::nullopt;
    return std::array{sums_[0], sums_[n_rays_ - 1]};
  }

 private:
  /// @return Whether all crossings below a node are sure.
  bool descend(std::size_t level, std::size_t i) {
    for (unsigned bits = all_.levels_[level][i].meeting(box_); bits != 0; bits &= bits - 1) {
      const std::size_t child = kTreeWidth * i + static_cast<std::size_t>(std::countr_zero(bits));
      if (level != 0) {
        if (!descend(level - 1, child)) return false;
      } else {
        for (std::size_t ray = 0; ray < n_rays_; ++ray) {
          if (!meet(all_.triangles_[child], ray)) return false;
        }
      }
    }
    return true;
  }

  /// @return Whether it is sure how a ray meets the triangle, or that it does not.
  bool meet(const Corners& t, std::size_t ray) {
    const Vec3& start = starts_[ray];
    const int first = sure_side(t[0], t[1], start);
    const int second = sure_side(t[1], t[2], start);
    if (first * second < 0) return true;
    const int third = sure_side(t[2], t[0], start);
    if (first * third < 0 || second * third < 0) return true;
    if (first == 0 || second == 0 || third == 0) return false;
    const Vec3 u = t[1] - t[0];
    const Vec3 v = t[2] - t[0];
    const Vec3 normal = u.cross(v);
    const Vec3 to_start = start - t[0];
    const double height = normal.dot(to_start);
    const double largest = u.norm() * v.norm() * to_start.norm();
    if (std::abs(height) <= all_.near_ * normal.norm() + kRoundingOfRays * largest) return false;
    // A triangle that is counter-clockwise along x has its front at larger x, so that it lies at
    // larger x than a start behind it.
    const bool lies_above = (height < 0.0) == (first > 0);
    if (lies_above == runs_up_) sums_[ray] += runs_up_ ? first : -first;
    return true;
  }

  const RayWindings& all_;
  std::array<Vec3, 2> starts_;
  /// One if both points are the same.
  std::size_t n_rays_;
  /// Tells whether the rays run to larger x: that of the first point takes the shorter way out.
  bool runs_up_;
  TreeBox box_;
  std::array<int, 2> sums_{};
};

RayWindings::RayWindings(std::span<const Corners> triangles, double near) : near_(near) {
  triangles_.reserve(triangles.size());
  for (const Corners& t : triangles) {
    triangles_.push_back({frame() * t[0], frame() * t[1], frame() * t[2]});
  }
  std::vector<Corners> ordered;
  ordered.reserve(triangles.size());
  for (const Index i : order_by_size(triangles_)) ordered.push_back(triangles_[i]);
  triangles_ = std::move(ordered);
  if (triangles_.empty()) return;
  levels_.emplace_back(n_chunks(triangles_.size(), kTreeWidth), EightBoxes::empty());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Box3 box = box_of(triangles_[i]);
    levels_.front()[i / kTreeWidth].set(i % kTreeWidth,
                                        {to_floats(box.min()), to_floats(box.max())});
  }
  while (levels_.back().size() > 1) levels_.push_back(boxes_above(levels_.back()));
}

std::optional<std::array<int, 2>> RayWindings::at_both(const Vec3& first,
                                                       const Vec3& second) const {
  return TwoRays(*this, frame() * first, frame() * second).follow();
}

}  // namespace meshalyzer
