#include "meshalyzer/repair/driver/internal/convex_piece.h"

#include <algorithm>

namespace meshalyzer {

ConvexPiece::ConvexPiece(const Corners& triangle) {
  for (const Vec3& corner : triangle) add(corner);
}

Vec3 ConvexPiece::middle() const {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& corner : corners()) sum += corner / static_cast<double>(n_corners_);
  return sum;
}

Box3 ConvexPiece::box() const {
  Box3 box;
  for (const Vec3& corner : corners()) box.extend(corner);
  return box;
}

double ConvexPiece::area(double unit) const {
  Vec3 twice = Vec3::Zero();
  for (std::size_t i = 2; i < n_corners_; ++i) {
    twice += ((corners_[i - 1] - corners_[0]) / unit).cross((corners_[i] - corners_[0]) / unit);
  }
  return twice.norm() / 2.0;
}

std::array<Vec3, 2> ConvexPiece::diameter() const {
  std::array<Vec3, 2> ends{corners_[0], corners_[0]};
  double longest = 0.0;
  for (std::size_t i = 0; i < n_corners_; ++i) {
    for (std::size_t k = i + 1; k < n_corners_; ++k) {
      const double length = (corners_[k] - corners_[i]).stableNorm();
      if (length <= longest) continue;
      longest = length;
      ends = {corners_[i], corners_[k]};
    }
  }
  return ends;
}

ConvexPiece::Parts ConvexPiece::cut(const HalfSpace& half_space) const {
  std::array<double, kMostCorners> excess;
  for (std::size_t i = 0; i < n_corners_; ++i) excess[i] = half_space.excess(corners_[i]);
  const auto crosses = [&](std::size_t i, std::size_t next) {
    return std::min(excess[i], excess[next]) < 0.0 && std::max(excess[i], excess[next]) > 0.0;
  };
  Parts parts;
  std::size_t n_crossings = 0;
  for (std::size_t i = 0; i < n_corners_; ++i) {
    const std::size_t next = (i + 1) % n_corners_;
    if (excess[i] <= 0.0) parts.inside.add(corners_[i]);
    if (excess[i] >= 0.0) parts.outside.add(corners_[i]);
    if (!crosses(i, next)) continue;
    if (++n_crossings > 2) return {*this, {}};
    const double at = excess[i] / (excess[i] - excess[next]);
    const Vec3 crossing = between(corners_[i], corners_[next], at);
    parts.inside.add(crossing);
    parts.outside.add(crossing);
  }
  // What lies in the plane is not lost with a part: it belongs to the other one, too.
  const auto is_any = [&](auto&& is_beyond) {
    return std::any_of(excess.data(), excess.data() + n_corners_, is_beyond);
  };
  if (!is_any([](double e) { return e > 0.0; })) return {*this, {}};
  if (!is_any([](double e) { return e < 0.0; })) return {{}, *this};
  return parts;
}

ConvexPiece::Parts ConvexPiece::cut_between_corners() const {
  Parts parts;
  const std::size_t opposite = n_corners_ / 2;
  for (std::size_t i = 0; i <= opposite; ++i) parts.inside.add(corners_[i]);
  for (std::size_t i = opposite; i < n_corners_; ++i) parts.outside.add(corners_[i]);
  parts.outside.add(corners_[0]);
  return parts;
}

ConvexPiece ConvexPiece::part_in(const Box3& box) const {
  ConvexPiece part = *this;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Vec3 up = Vec3::Unit(axis);
    part = part.cut({Vec3::Zero(), up, box.max()[axis]}).inside;
    part = part.cut({Vec3::Zero(), -up, -box.min()[axis]}).inside;
  }
  return part;
}

}  // namespace meshalyzer
