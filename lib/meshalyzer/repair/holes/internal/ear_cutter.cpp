#include "meshalyzer/repair/holes/internal/ear_cutter.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace meshalyzer {

EarCutter::EarCutter(std::span<const Vec3> polygon, std::vector<PlaneView> views,
                     const EarRules& rules)
    : polygon_(polygon),
      views_(std::move(views)),
      rules_(rules),
      n_left_(polygon.size()),
      is_left_(polygon.size(), 1) {
  const std::size_t n = polygon.size();
  for (Index i = 0; i < n; ++i) {
    before_.push_back(i == 0 ? static_cast<Index>(n - 1) : i - 1);
    after_.push_back(i + 1 < n ? i + 1 : 0);
  }
}

CornerGrid::Point EarCutter::flat(Axis dropped, Index corner) const {
  const auto axis = static_cast<Eigen::Index>(dropped);
  return {polygon_[corner][(axis + 1) % 3], polygon_[corner][(axis + 2) % 3]};
}

EarCutter::Grids EarCutter::make_grids() const {
  const std::vector<Index> left = corners_left();
  Grids grids;
  for (const PlaneView& view : views_) {
    std::optional<CornerGrid>& grid = grids[static_cast<std::size_t>(view.dropped)];
    if (grid) continue;
    std::vector<CornerGrid::Point> points;
    for (Index i = 0; i < polygon_.size(); ++i) points.push_back(flat(view.dropped, i));
    grid.emplace(points, left);
  }
  return grids;
}

void EarCutter::cut(EarDemand demand, std::size_t n_wanted) {
  std::size_t n_in_grids = n_left_;
  Grids grids = make_grids();
  std::priority_queue<Ear> ears;
  for (const Index i : corners_left()) ears.push(ear_at(i));
  while (n_left_ > n_wanted && !ears.empty()) {
    const Ear ear = ears.top();
    ears.pop();
    if (!is_current(ear) || (n_left_ > 3 && !rules_.allows(ear.corners)) ||
        !meets(demand, ear.corners, grids)) {
      continue;
    }
    remove_tip(ear.corners);
    ears.push(ear_at(ear.corners[0]));
    ears.push(ear_at(ear.corners[2]));
    if (n_left_ < n_in_grids / 2) {
      grids = make_grids();
      n_in_grids = n_left_;
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

bool EarCutter::meets(EarDemand demand, const Triangle& ear, const Grids& grids) const {
  if (demand == EarDemand::Nothing) return true;
  if (view_at(ear[1]).turn(polygon_[ear[0]], polygon_[ear[1]], polygon_[ear[2]]) <= 0) return false;
  return demand == EarDemand::Convex || is_empty(ear, grids);
}

bool EarCutter::is_empty(const Triangle& ear, const Grids& grids) const {
  const PlaneView& view = view_at(ear[1]);
  const auto axis = static_cast<Eigen::Index>(view.dropped);
  const Corners corners{polygon_[ear[0]], polygon_[ear[1]], polygon_[ear[2]]};
  const std::array<CornerGrid::Point, 3> flat_ear{
      flat(view.dropped, ear[0]), flat(view.dropped, ear[1]), flat(view.dropped, ear[2])};
  Eigen::AlignedBox2d box(flat_ear[0]);
  box.extend(flat_ear[1]).extend(flat_ear[2]);
  const double depth = depth_of(ear);
  return !grids[static_cast<std::size_t>(view.dropped)]->any_near(flat_ear, [&](Index i) {
    if (is_left_[i] == 0 || std::abs(polygon_[i][axis] - corners[1][axis]) > depth) return false;
    const CornerGrid::Point p = flat(view.dropped, i);
    const bool is_at_corner = p == flat_ear[0] || p == flat_ear[1] || p == flat_ear[2];
    return box.contains(p) && !is_at_corner && view.covers(corners, polygon_[i]);
  });
}

double EarCutter::depth_of(const Triangle& ear) const {
  if (has_one_view()) return std::numeric_limits<double>::infinity();
  const Vec3& tip = polygon_[ear[1]];
  return std::max({(polygon_[ear[0]] - tip).norm(), (polygon_[ear[2]] - tip).norm(),
                   (polygon_[ear[2]] - polygon_[ear[0]]).norm()});
}

void EarCutter::remove_tip(const Triangle& ear) {
  triangles_.push_back(ear);
  after_[ear[0]] = ear[2];
  before_[ear[2]] = ear[0];
  is_left_[ear[1]] = 0;
  --n_left_;
}

}  // namespace meshalyzer
