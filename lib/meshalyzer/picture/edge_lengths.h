#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/picture/drawing_frame.h"

#include <span>
#include <vector>

namespace meshalyzer {

// Private to the picture module: how coarse a mesh is, and where.

/// Mean lengths of the edges at the vertices, in drawn coordinates; an edge counts once for each of
/// its faces.
class EdgeLengths {
 public:
  /// @param faces  Those that count; drawable.
  EdgeLengths(const Soup& soup, const DrawingFrame& frame, std::span<const Index> faces);

  /// At a vertex; of the whole mesh where no face uses it.
  [[nodiscard]] double at(Index vertex) const {
    return count_[vertex] == 0 ? mean_ : sum_[vertex] / static_cast<double>(count_[vertex]);
  }
  /// Of the whole mesh; 0 where it has no face.
  [[nodiscard]] double mean() const { return mean_; }

 private:
  std::vector<double> sum_;
  std::vector<Index> count_;
  double mean_ = 0.0;
};

}  // namespace meshalyzer
