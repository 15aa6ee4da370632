#pragma once

#include "meshalyzer/arrangement/named_points.h"

#include <vector>

namespace meshalyzer {

/// The points of an arrangement where something is cut, each once: corners of the faces that are
/// cut, and points where these meet.
///
/// Nodes are numbered in lexicographic order of their exact coordinates, so that along any line,
/// and for a sweep over any plane, they are in order. That does not depend on numbering.
struct Nodes {
  /// #nodes.
  std::vector<ExactPoint> points;
  /// The node of each point of the first and of the second table, by number.
  std::vector<Index> of_first;
  std::vector<Index> of_second;
};

/// Makes one node of all names that are of one point, by comparing exactly.
[[nodiscard]] Nodes unite_points(const NamedPoints& first, const NamedPoints& second);

}  // namespace meshalyzer
