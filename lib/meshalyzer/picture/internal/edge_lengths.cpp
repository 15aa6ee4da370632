#include "meshalyzer/picture/internal/edge_lengths.h"

namespace meshalyzer {

EdgeLengths::EdgeLengths(const Soup& soup, const DrawingFrame& frame, std::span<const Index> faces)
    : sum_(soup.n_vertices(), 0.0), count_(soup.n_vertices(), 0) {
  double sum = 0.0;
  for (const Index f : faces) {
    const Triangle& t = soup.triangles[f];
    const std::array<Vec3, 3> corners{frame(soup.positions[t[0]]), frame(soup.positions[t[1]]),
                                      frame(soup.positions[t[2]])};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = i == 2 ? 0 : i + 1;
      const double length = (corners[next] - corners[i]).norm();
      sum += length;
      for (const Index v : {t[i], t[next]}) {
        sum_[v] += length;
        ++count_[v];
      }
    }
  }
  if (!faces.empty()) mean_ = sum / (3.0 * static_cast<double>(faces.size()));
}

}  // namespace meshalyzer
