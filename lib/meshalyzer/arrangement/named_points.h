#pragma once

#include "meshalyzer/arrangement/point_name.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// A table of points and their names. One point may occur several times, under different names.
class NamedPoints {
 public:
  /// Constructs the points in parallel.
  /// @param names  The names, ascending, each once.
  NamedPoints(const Soup& soup, std::vector<PointName> names);

  [[nodiscard]] std::size_t size() const { return names_.size(); }
  /// Returns the names, ascending.
  [[nodiscard]] const std::vector<PointName>& names() const { return names_; }
  /// Returns the number of a name, which must be one of those given.
  [[nodiscard]] Index find(const PointName& name) const;
  [[nodiscard]] const ExactPoint& operator[](Index i) const { return points_[i]; }

 private:
  std::vector<PointName> names_;
  std::vector<ExactPoint> points_;
};

}  // namespace meshalyzer
