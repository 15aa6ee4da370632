#include "meshalyzer/repair/holes/internal/ear_cutter.h"

#include <Eigen/Geometry>

#include <queue>

namespace meshalyzer {

EarCutter::EarCutter(std::span<const Vec3> polygon, const PlaneView& view, const EarRules& rules)
    : polygon_(polygon),
      view_(view),
      rules_(rules),
      n_left_(polygon.size()),
      is_left_(polygon.size(), 1) {
  const std::size_t n = polygon.size();
  const auto axis = static_cast<Eigen::Index>(view_.dropped);
  for (Index i = 0; i < n; ++i) {
    before_.push_back(i == 0 ? static_cast<Index>(n - 1) : i - 1);
    after_.push_back(i + 1 < n ? i + 1 : 0);
    flat_.emplace_back(polygon[i][(axis + 1) % 3], polygon[i][(axis + 2) % 3]);
  }
}

void EarCutter::cut(EarDemand demand, std::size_t n_wanted) {
  const std::vector<Index> left = corners_left();
  std::size_t n_in_grid = left.size();
  CornerGrid grid(flat_, left);
  std::priority_queue<Ear> ears;
  for (const Index i : left) ears.push(ear_at(i));
  while (n_left_ > n_wanted && !ears.empty()) {
    const Ear ear = ears.top();
    ears.pop();
    if (!is_current(ear) || (n_left_ > 3 && !rules_.allows(ear.corners)) ||
        !meets(demand, ear.corners, grid)) {
      continue;
    }
    remove_tip(ear.corners);
    ears.push(ear_at(ear.corners[0]));
    ears.push(ear_at(ear.corners[2]));
    if (n_left_ < n_in_grid / 2) {
      grid = CornerGrid(flat_, corners_left());
      n_in_grid = n_left_;
    }
  }
}

std::vector<Index> EarCutter::corners_left() const {
  std::vector<Index> left;
  for (Index i = 0; i < is_left_.size(); ++i) {
    if (is_left_[i] != 0) left.push_back(i);
  }
  return left;
}

EarCutter::Ear EarCutter::ear_at(Index tip) const {
  const Triangle corners{before_[tip], tip, after_[tip]};
  return {rules_.cost(corners), corners};
}

bool EarCutter::is_current(const Ear& ear) const {
  const Index tip = ear.tip();
  return is_left_[tip] != 0 && before_[tip] == ear.corners[0] && after_[tip] == ear.corners[2];
}

bool EarCutter::meets(EarDemand demand, const Triangle& ear, const CornerGrid& grid) const {
  if (demand == EarDemand::Nothing) return true;
  if (view_.turn(polygon_[ear[0]], polygon_[ear[1]], polygon_[ear[2]]) <= 0) return false;
  return demand == EarDemand::Convex || is_empty(ear, grid);
}

bool EarCutter::is_empty(const Triangle& ear, const CornerGrid& grid) const {
  const std::array<CornerGrid::Point, 3> flat{flat_[ear[0]], flat_[ear[1]], flat_[ear[2]]};
  const Corners corners{polygon_[ear[0]], polygon_[ear[1]], polygon_[ear[2]]};
  Eigen::AlignedBox2d box(flat[0]);
  box.extend(flat[1]).extend(flat[2]);
  return !grid.any_near(flat, [&](Index i) {
    const auto& p = flat_[i];
    const bool is_at_corner = p == flat[0] || p == flat[1] || p == flat[2];
    return is_left_[i] != 0 && box.contains(p) && !is_at_corner &&
           view_.covers(corners, polygon_[i]);
  });
}

void EarCutter::remove_tip(const Triangle& ear) {
  triangles_.push_back(ear);
  after_[ear[0]] = ear[2];
  before_[ear[2]] = ear[0];
  is_left_[ear[1]] = 0;
  --n_left_;
}

}  // namespace meshalyzer
