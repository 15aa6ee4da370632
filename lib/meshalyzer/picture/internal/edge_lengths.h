#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/picture/internal/drawing_frame.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// Mean lengths of the edges at the vertices, in drawn coordinates; an edge counts once for each of
/// its faces.
class EdgeLengths {
 public:
  /// @param faces  The faces whose edges count; all must be drawable.
  EdgeLengths(const Soup& soup, const DrawingFrame& frame, std::span<const Index> faces);

  /// Returns the mean at a vertex, or that of the whole mesh if no face uses the vertex.
  [[nodiscard]] double at(Index vertex) const {
    return count_[vertex] == 0 ? mean_ : sum_[vertex] / static_cast<double>(count_[vertex]);
  }
  /// Returns the mean of the whole mesh; 0 if it has no face.
  [[nodiscard]] double mean() const { return mean_; }

 private:
  std::vector<double> sum_;
  std::vector<Index> count_;
  double mean_ = 0.0;
};

}  // namespace meshalyzer
