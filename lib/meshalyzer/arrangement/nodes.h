#pragma once

#include "meshalyzer/arrangement/named_points.h"

#include <vector>

namespace meshalyzer {

/// The points of an arrangement at which faces are cut, each once: the corners of these faces, and
/// the points where they meet.
///
/// Nodes are numbered in lexicographic order of their exact coordinates, so that they are sorted
/// along any line and for a sweep over any plane. Their order does not depend on the numbering of
/// the input.
struct Nodes {
  /// The position of each node.
  std::vector<ExactPoint> points;
  /// The node of each point of the first and of the second table, by number.
  std::vector<Index> of_first;
  std::vector<Index> of_second;
};

/// Makes one node of all names of the same point, by exact comparison.
[[nodiscard]] Nodes unite_points(const NamedPoints& first, const NamedPoints& second);

}  // namespace meshalyzer
