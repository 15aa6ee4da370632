#include "meshalyzer/geometry/coincidence.h"

#include "meshalyzer/geometry/crowded_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace meshalyzer {
namespace {

/// Returns how far apart coordinates may be if the larger has this magnitude.
double tolerance(double magnitude) {
  return 1e-10 * std::max(1.0, magnitude);
}

double larger_magnitude(double a, double b) {
  return std::max(std::abs(a), std::abs(b));
}

/// A point and one of its coordinates.
struct KeyedPoint {
  double coordinate = 0.0;
  Index point = 0;
};

/// A point and its cell of a grid.
struct CelledPoint {
  std::array<std::int64_t, 3> cell{};
  Index point = 0;
};

/// From this many points on it pays to distribute them before they are sorted.
constexpr std::size_t kManyPoints = 1000;

bool comes_before(const KeyedPoint& a, const KeyedPoint& b) {
  return a.coordinate < b.coordinate;
}

/// Puts points into as many intervals of equal width, one interval after the other.
///
/// @param per_unit  The number of intervals by width; finite.
/// @return          Where each interval ends.
std::vector<Index> distribute(std::span<KeyedPoint> points, double low, double per_unit) {
  const auto interval = [&](const KeyedPoint& p) {
    return std::min(static_cast<std::size_t>((p.coordinate - low) * per_unit), points.size() - 1);
  };
  std::vector<Index> places(points.size(), 0);
  for (const KeyedPoint& p : points) ++places[interval(p)];
  std::exclusive_scan(places.begin(), places.end(), places.begin(), Index{0});
  const std::vector<KeyedPoint> copies(points.begin(), points.end());
  for (const KeyedPoint& p : copies) points[places[interval(p)]++] = p;
  return places;
}

/// Sorts in linear time where the coordinates are spread out.
void sort_by_coordinate(std::span<KeyedPoint> points) {
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), comes_before);
  const double per_unit = static_cast<double>(points.size()) / (high->coordinate - low->coordinate);
  if (points.size() < kManyPoints || !std::isnormal(per_unit)) {
    std::sort(points.begin(), points.end(), comes_before);
    return;
  }
  std::size_t begin = 0;
  for (const Index end : distribute(points, low->coordinate, per_unit)) {
    const std::span<KeyedPoint> interval = points.subspan(begin, end - begin);
    std::sort(interval.begin(), interval.end(), comes_before);
    begin = end;
  }
}

/// At most this many points are compared each with each.
constexpr std::size_t kFewPoints = 16;

/// Grid cells are 0.9 tolerances wide, so that all points of one cell are at the same place. The
/// tolerance grows along a chain of n points by a factor of e^(2e-10 n) at most, 1.54 for 2^31
/// points, so that a point at the same place is less than 1.54 / 0.9 < 2 cells away.
constexpr double kCellWidth = 0.9;
constexpr std::int64_t kCellReach = 2;

/// One axis of a grid.
struct GridAxis {
  double origin = std::numeric_limits<double>::infinity();
  double smallest_magnitude = std::numeric_limits<double>::infinity();

  void include(double coordinate) {
    origin = std::min(origin, coordinate);
    smallest_magnitude = std::min(smallest_magnitude, std::abs(coordinate));
  }
  [[nodiscard]] std::int64_t cell(double coordinate) const {
    const double width = kCellWidth * tolerance(smallest_magnitude);
    return static_cast<std::int64_t>(std::floor((coordinate - origin) / width));
  }
};

/// Marks the points that have another point at the same place.
///
/// Points are sorted by x and cut into chains wherever neighbours are too far apart for any two
/// points on either side to be at the same place; chains are cut by y in the same way, then by z.
/// Chains that remain are dense and are searched with a grid.
class CoincidenceSearch {
 public:
  CoincidenceSearch(std::span<const Vec3> positions, Coincidence coincidence)
      : positions_(positions), coincidence_(coincidence), marked_(positions.size(), 0) {}

  [[nodiscard]] std::vector<Index> run() {
    std::vector<KeyedPoint> points(positions_.size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i].point = static_cast<Index>(i);
    cut_into_chains(points, 0);
    std::vector<Index> found;
    for (std::size_t i = 0; i < marked_.size(); ++i) {
      if (marked_[i] != 0) found.push_back(static_cast<Index>(i));
    }
    return found;
  }

 private:
  void cut_into_chains(std::span<KeyedPoint> points, Eigen::Index axis) {
    if (points.size() < 2) return;
    if (axis == 3) return compare(points);
    for (KeyedPoint& p : points) p.coordinate = positions_[p.point][axis];
    sort_by_coordinate(points);
    std::size_t begin = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (!is_apart(points[i - 1].coordinate, points[i].coordinate)) continue;
      cut_into_chains(points.subspan(begin, i - begin), axis + 1);
      begin = i;
    }
    cut_into_chains(points.subspan(begin), axis + 1);
  }

  /// Tells whether no coordinate up to `low` is at the same place as one from `high` on. The latter
  /// may have larger magnitudes and hence a larger tolerance, but by less than a factor of 2.
  [[nodiscard]] bool is_apart(double low, double high) const {
    if (coincidence_ == Coincidence::Exact) return low != high;
    return high - low > 2 * tolerance(larger_magnitude(low, high));
  }

  void compare(std::span<const KeyedPoint> points) {
    if (coincidence_ == Coincidence::Exact) {
      for (const KeyedPoint& p : points) marked_[p.point] = 1;
    } else if (points.size() <= kFewPoints) {
      compare_each_with_each(points);
    } else {
      compare_in_grid(points);
    }
  }

  void compare_each_with_each(std::span<const KeyedPoint> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        if (is_same_place(points[i].point, points[j].point)) {
          marked_[points[i].point] = marked_[points[j].point] = 1;
        }
      }
    }
  }

  void compare_in_grid(std::span<const KeyedPoint> points) {
    const std::vector<CelledPoint> grid = sort_into_grid(points);
    std::vector<CelledPoint> lone;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const bool has_company = (i > 0 && grid[i - 1].cell == grid[i].cell) ||
                               (i + 1 < grid.size() && grid[i + 1].cell == grid[i].cell);
      if (has_company) marked_[grid[i].point] = 1;
      if (!has_company) lone.push_back(grid[i]);
    }
    for (std::int64_t dx = -kCellReach; dx <= kCellReach; ++dx) {
      for (std::int64_t dy = -kCellReach; dy <= kCellReach; ++dy) {
        compare_with_row(lone, grid, {dx, dy});
      }
    }
  }

  [[nodiscard]] std::vector<CelledPoint> sort_into_grid(std::span<const KeyedPoint> points) const {
    std::array<GridAxis, 3> axes;
    for (const KeyedPoint& p : points) {
      for (std::size_t k = 0; k < 3; ++k) axes[k].include(coordinate(p.point, k));
    }
    std::vector<CelledPoint> grid;
    grid.reserve(points.size());
    for (const KeyedPoint& p : points) {
      CelledPoint& celled = grid.emplace_back();
      celled.point = p.point;
      for (std::size_t k = 0; k < 3; ++k) {
        celled.cell[k] = axes[k].cell(coordinate(p.point, k));
      }
    }
    std::sort(grid.begin(), grid.end(),
              [](const CelledPoint& a, const CelledPoint& b) { return a.cell < b.cell; });
    return grid;
  }

  /// Compares points that are alone in their cells with those of the cells in reach in a column at
  /// the given distance. Both lists are ordered by cell, so one pass is enough; no point is visited
  /// more than 5 times in a pass, because few cells have a given cell in reach.
  void compare_with_row(std::span<const CelledPoint> lone, std::span<const CelledPoint> grid,
                        const std::array<std::int64_t, 2>& column) {
    std::size_t first = 0;
    for (const CelledPoint& p : lone) {
      const std::array<std::int64_t, 3> lowest{p.cell[0] + column[0], p.cell[1] + column[1],
                                               p.cell[2] - kCellReach};
      std::array<std::int64_t, 3> highest = lowest;
      highest[2] = p.cell[2] + kCellReach;
      while (first < grid.size() && grid[first].cell < lowest) ++first;
      for (std::size_t i = first; i < grid.size() && grid[i].cell <= highest; ++i) {
        if (marked_[p.point] != 0) break;
        if (grid[i].point != p.point && is_same_place(p.point, grid[i].point)) marked_[p.point] = 1;
      }
    }
  }

  [[nodiscard]] bool is_same_place(Index a, Index b) const {
    return is_indistinguishable(positions_[a], positions_[b], coincidence_);
  }
  [[nodiscard]] double coordinate(Index point, std::size_t axis) const {
    return positions_[point][static_cast<Eigen::Index>(axis)];
  }

  std::span<const Vec3> positions_;
  Coincidence coincidence_;
  std::vector<std::uint8_t> marked_;
};

}  // namespace

bool is_indistinguishable(const Vec3& a, const Vec3& b, Coincidence coincidence) {
  if (coincidence == Coincidence::Exact) return a == b;
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (std::abs(a[k] - b[k]) > tolerance(larger_magnitude(a[k], b[k]))) return false;
  }
  return true;
}

std::vector<Index> find_indistinguishable_vertices(std::span<const Vec3> positions,
                                                   Coincidence coincidence) {
  const std::vector<Index> crowded = find_crowded_points(positions);
  std::vector<Vec3> at(crowded.size());
  std::transform(crowded.begin(), crowded.end(), at.begin(), [&](Index i) { return positions[i]; });
  std::vector<Index> found = CoincidenceSearch(at, coincidence).run();
  for (Index& i : found) i = crowded[i];
  return found;
}

}  // namespace meshalyzer
