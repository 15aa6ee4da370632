#include "meshalyzer/spatial/oriented_boxes.h"

#include "meshalyzer/spatial/tree_width.h"

#include <algorithm>
#include <limits>

namespace meshalyzer {
namespace {

/// Places along a direction of length 1 are off by less than this: coordinates are at most 1 and
/// off by 2^-24, those of the direction too, and the bound is rounded once.
constexpr double kPlaceSlack = 0x1p-21;

using Axes = std::array<Vec3, 3>;

/// The corners of the faces of a leaf, three for each.
struct LeafCorners {
  std::array<Vec3, 3 * kTreeWidth> points;
  std::size_t n_faces = 0;

  LeafCorners(const EightTriangles& triangles, std::size_t n) : n_faces(n) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < 3; ++k) {
          points[3 * i + c][static_cast<Eigen::Index>(k)] =
              static_cast<double>(triangles.corners[c][k][i]);
        }
      }
    }
  }
  [[nodiscard]] std::span<const Vec3> all() const { return std::span(points).first(3 * n_faces); }
};

Vec3 mean_normal(const LeafCorners& corners) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < 3 * corners.n_faces; i += 3) {
    const auto& p = corners.points;
    sum += (p[i + 1] - p[i]).cross(p[i + 2] - p[i]);
  }
  return sum;
}

/// Returns three directions at right angles, of length 1, the first along the mean normal of the
/// faces. They are those of the axes where there is no such normal.
Axes axes_of(const LeafCorners& corners) {
  const Vec3 normal = mean_normal(corners).normalized();
  Box3 box;
  for (const Vec3& p : corners.all()) box.extend(p);
  const Vec3 widths = box.sizes().cwiseProduct(
      (Vec3::Ones() - normal.cwiseAbs2()).cwiseMax(Vec3::Zero()).cwiseSqrt());
  Eigen::Index widest = 0;
  widths.maxCoeff(&widest);
  const Vec3 across = normal.cross(Vec3::Unit(widest)).normalized();
  // Both are of length 1 or, if that was not possible, shorter.
  if (normal.squaredNorm() < 0.5 || across.squaredNorm() < 0.5) {
    return {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  }
  return {normal, across, normal.cross(across)};
}

}  // namespace

EightOrientedBoxes oriented_boxes_of(const FaceTree& tree,
                                     std::span<const EightTriangles> triangles,
                                     std::size_t first_leaf) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  EightOrientedBoxes boxes{};
  for (std::size_t lane = 0; lane < kTreeWidth; ++lane) {
    const std::size_t leaf = first_leaf + lane;
    const bool is_empty = 8 * leaf >= tree.n_faces();
    if (is_empty || tree.is_far_leaf(leaf)) {
      for (std::size_t a = 0; a < 3; ++a) {
        boxes.low[a][lane] = is_empty ? infinity : -infinity;
        boxes.high[a][lane] = is_empty ? -infinity : infinity;
      }
      continue;
    }
    const LeafCorners corners(triangles[leaf], std::min<std::size_t>(8, tree.n_faces() - 8 * leaf));
    const Axes axes = axes_of(corners);
    for (std::size_t a = 0; a < 3; ++a) {
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (const Vec3& p : corners.all()) {
        const double place = axes[a].dot(p);
        low = std::min(low, place);
        high = std::max(high, place);
      }
      boxes.low[a][lane] = static_cast<float>(low - kPlaceSlack);
      boxes.high[a][lane] = static_cast<float>(high + kPlaceSlack);
      for (std::size_t k = 0; k < 3; ++k) {
        boxes.axes[a][k][lane] = static_cast<float>(axes[a][static_cast<Eigen::Index>(k)]);
      }
    }
  }
  return boxes;
}

}  // namespace meshalyzer
