#pragma once

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/repair/pass.h"
#include "meshalyzer/repair/weld/internal/weld_edges.h"

#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): the vertices that are merged.

/// Returns how many faces of the complex use each vertex.
[[nodiscard]] std::vector<Index> count_faces_at_vertices(const Soup& soup);

/// The rules for which of several vertices stays, and how far the others may move. This holds
/// references only.
struct WeldRules {
  const PassInput& input;
  std::span<const Index> faces_at_vertices;
  /// The length within which vertices must be to be joined.
  double reach = 0.0;
};

/// Tells whether `a` stays of two: the fixed one, or the one with more faces, or the lower.
[[nodiscard]] bool is_preferred(const WeldRules& rules, Index a, Index b);

/// Sets of vertices that are merged, each at the position of its representative.
class WeldClasses {
 public:
  explicit WeldClasses(const WeldRules& rules);

  /// Joins the ends of two edges, unless a vertex would have to move too far, a fixed one would
  /// have to move, or two corners of the face of either would become one.
  ///
  /// @return The reason why it was not done; empty if it was.
  [[nodiscard]] std::string_view join(const WeldEdge& a, const WeldEdge& b, EdgeRun run);

  /// #V: the vertex that stays of those that each vertex is merged with.
  [[nodiscard]] std::vector<Index> representatives();
  [[nodiscard]] bool are_joined(Index a, Index b) { return sets_.find(a) == sets_.find(b); }
  /// Tells whether a vertex is joined with no other.
  [[nodiscard]] bool is_alone(Index v) const { return next_[v] == v; }

 private:
  [[nodiscard]] bool may_join(Index a, Index b);
  [[nodiscard]] bool can_go(Index root, Index to) const;
  void unite(Index a, Index b);

  WeldRules rules_;
  DisjointSets sets_;
  /// The members of each set as a ring.
  std::vector<Index> next_;
  /// The representative of each set, indexed by root.
  std::vector<Index> representative_;
};

}  // namespace meshalyzer
