#include "meshalyzer/spatial/leaf_frame.h"

#include "meshalyzer/spatial/eight_reaches.h"

#include <algorithm>

namespace meshalyzer {

LeafFrame::LeafFrame(const LeafTriangles& faces,
                     const std::array<std::array<float, 3>, 2>& directions)
    : reaches_{reaches_along(directions[0], faces), reaches_along(directions[1], faces)} {}

LeafFrame::Reaches LeafFrame::reaches_along(const std::array<float, 3>& direction,
                                            const LeafTriangles& faces) {
  Reaches reaches{direction, {}, {}};
  const float slack = gap_slack(direction);
  for (std::size_t i = 0; i < 8; ++i) {
    std::array<float, 3> along;
    for (std::size_t c = 0; c < 3; ++c) {
      along[c] = direction[0] * faces.corners[c][0][i] + direction[1] * faces.corners[c][1][i] +
                 direction[2] * faces.corners[c][2][i];
    }
    const auto [low, high] = std::minmax_element(along.begin(), along.end());
    reaches.low[i] = *low - slack;
    reaches.high[i] = *high + slack;
  }
  return reaches;
}

void LeafFrame::drop_apart(const LeafTriangles& others, Partners& partners) const {
  const EightCorners corners = loaded(others);
  for (const Reaches& mine : reaches_) {
    const EightReaches theirs(eight_times(mine.direction), corners);
    for (std::size_t i = 0; i < 8; ++i) {
      const EightFlags apart = (EightFloats::all(mine.high[i]) < theirs.low) |
                               (theirs.high < EightFloats::all(mine.low[i]));
      partners[i] &= ~apart.bits();
    }
  }
}

}  // namespace meshalyzer
