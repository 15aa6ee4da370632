#include "meshalyzer/arrangement/triangulation.h"

namespace meshalyzer {

Index Triangulation::add_triangle(Index a, Index b, Index c) {
  const auto h = static_cast<Index>(origin.size());
  origin.insert(origin.end(), {a, b, c});
  twin.insert(twin.end(), 3, kNoIndex);
  constrained.insert(constrained.end(), 3, 0);
  leaving[a] = h;
  leaving[b] = h + 1;
  leaving[c] = h + 2;
  return h;
}

void Triangulation::link(Index h, Index g) {
  if (h != kNoIndex) twin[h] = g;
  if (g != kNoIndex) twin[g] = h;
}

void Triangulation::constrain(Index h) {
  constrained[h] = 1;
  if (twin[h] != kNoIndex) constrained[twin[h]] = 1;
}

void Triangulation::collect_leaving(Index vertex, std::vector<Index>& halfedges) const {
  halfedges.clear();
  const Index first = leaving[vertex];
  Index h = first;
  do {
    halfedges.push_back(h);
    h = twin[previous(h)];
  } while (h != kNoIndex && h != first);
  if (h == first) return;
  // The hull is on the left: continue to the right of the first half-edge.
  for (h = twin[first]; h != kNoIndex; h = twin[h]) {
    h = next(h);
    halfedges.push_back(h);
  }
}

}  // namespace meshalyzer
