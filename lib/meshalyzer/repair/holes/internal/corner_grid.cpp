#include "meshalyzer/repair/holes/internal/corner_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

std::size_t index_below(double x, std::size_t n) {
  if (!(x > 0.0)) return 0;
  return std::min(n - 1, static_cast<std::size_t>(std::min(x, static_cast<double>(n))));
}

}  // namespace

CornerGrid::CornerGrid(const std::vector<Point>& points, const std::vector<Index>& listed) {
  Eigen::AlignedBox2d box;
  for (const Index i : listed) box.extend(points[i]);
  if (!box.isEmpty()) {
    low_ = box.min();
    const Point size = box.sizes();
    // There are about as many cells as points, but no more cells in a row than points.
    const double n = static_cast<double>(listed.size());
    const double cell = std::max(std::sqrt(size.x() * size.y() / n), size.maxCoeff() / n);
    per_length_ = cell > 0.0 ? 1.0 / cell : 0.0;
    if (!std::isfinite(per_length_)) per_length_ = 0.0;
    n_columns_ = index_below(size.x() * per_length_, listed.size()) + 1;
    n_rows_ = index_below(size.y() * per_length_, listed.size()) + 1;
  }
  points_ = ItemsByGroup(n_columns_ * n_rows_, [&](const auto& use) {
    for (const Index i : listed) {
      const auto [x, y] = cell_of(points[i]);
      use(y * n_columns_ + x, i);
    }
  });
}

std::array<std::size_t, 2> CornerGrid::cell_of(const Point& p) const {
  return {index_below((p.x() - low_.x()) * per_length_, n_columns_),
          index_below((p.y() - low_.y()) * per_length_, n_rows_)};
}

std::array<std::size_t, 2> CornerGrid::rows_of(const std::array<Point, 3>& triangle) const {
  const auto [low, high] = std::minmax({triangle[0].y(), triangle[1].y(), triangle[2].y()});
  return {index_below((low - low_.y()) * per_length_, n_rows_),
          index_below((high - low_.y()) * per_length_, n_rows_)};
}

std::array<std::size_t, 2> CornerGrid::columns_of(const std::array<Point, 3>& triangle,
                                                  std::size_t row) const {
  // The range is a little wider than the row, for rounding; in cells.
  const double below = static_cast<double>(row) - 0.01;
  const double above = static_cast<double>(row) + 1.01;
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  for (std::size_t i = 0; i < 3; ++i) {
    Point p = (triangle[i] - low_) * per_length_;
    Point q = (triangle[(i + 1) % 3] - low_) * per_length_;
    if (p.y() > q.y()) std::swap(p, q);
    if (q.y() < below || p.y() > above) continue;
    const double run = (q.x() - p.x()) / std::max(q.y() - p.y(), 1e-6);
    const double enter = p.y() < below ? p.x() + run * (below - p.y()) : p.x();
    const double leave = q.y() > above ? q.x() - run * (q.y() - above) : q.x();
    left = std::min({left, enter, leave});
    right = std::max({right, enter, leave});
  }
  return {index_below(left - 1.0, n_columns_), index_below(right + 1.0, n_columns_)};
}

}  // namespace meshalyzer
