#pragma once

#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/base/types.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace meshalyzer {

/// Points of a plane in square cells, to find those in a triangle.
class CornerGrid {
 public:
  using Point = Eigen::Vector2d;

  /// @param points  Points, which the grid names by number only.
  /// @param listed  The points that the grid holds.
  CornerGrid(const std::vector<Point>& points, const std::vector<Index>& listed);

  /// Calls `visit` with the number of each point in a triangle, and of some near it, until it
  /// returns true.
  ///
  /// @return Whether it returned true.
  template <typename Visit>
  bool any_near(const std::array<Point, 3>& triangle, Visit&& visit) const {
    const auto [first_row, last_row] = rows_of(triangle);
    for (std::size_t row = first_row; row <= last_row; ++row) {
      const auto [first_column, last_column] = columns_of(triangle, row);
      const std::size_t end = row * n_columns_ + last_column;
      for (std::size_t cell = row * n_columns_ + first_column; cell <= end; ++cell) {
        for (const Index point : points_[cell]) {
          if (visit(point)) return true;
        }
      }
    }
    return false;
  }

 private:
  /// The column and the row of a point; one outside counts to the nearest cell.
  [[nodiscard]] std::array<std::size_t, 2> cell_of(const Point& p) const;
  /// Returns the first and the last row that a triangle reaches.
  [[nodiscard]] std::array<std::size_t, 2> rows_of(const std::array<Point, 3>& triangle) const;
  /// Returns the first and the last column that it reaches in a row, with a margin of one on each
  /// side.
  [[nodiscard]] std::array<std::size_t, 2> columns_of(const std::array<Point, 3>& triangle,
                                                      std::size_t row) const;

  Point low_ = Point::Zero();
  double per_length_ = 0.0;
  std::size_t n_columns_ = 1;
  std::size_t n_rows_ = 1;
  /// #cells: the points in each.
  ItemsByGroup points_;
};

}  // namespace meshalyzer
