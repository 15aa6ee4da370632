#pragma once

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/repair/pass.h"
#include "meshalyzer/repair/weld/internal/weld_edges.h"

#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {

// Private to weld_borders(): which vertices are merged.

/// Returns how many faces of the complex use each vertex.
[[nodiscard]] std::vector<Index> count_faces_at_vertices(const Soup& soup);

/// The rules for which of several vertices stays, and how far the others may move. This holds
/// references only.
struct WeldRules {
  const PassInput& input;
  std::span<const Index> faces_at_vertices;
  /// No vertex is joined with one that is farther away. A length.
  double reach = 0.0;
};

/// Tells whether it is `a` that stays of two: that which is fixed, or of more faces, or the lower.
[[nodiscard]] bool is_preferred(const WeldRules& rules, Index a, Index b);

/// Sets of vertices that are merged, each at the position of its representative.
class WeldClasses {
 public:
  explicit WeldClasses(const WeldRules& rules);

  /// Joins the ends of two edges, unless a vertex would have to go too far, a fixed one would have
  /// to move, or the face of either would get two corners in one.
  ///
  /// @return Why it was not done; empty where it was.
  [[nodiscard]] std::string_view join(const WeldEdge& a, const WeldEdge& b, EdgeRun run);

  /// #V: the vertex that stays of those that each becomes one with.
  [[nodiscard]] std::vector<Index> representatives();
  [[nodiscard]] bool are_joined(Index a, Index b) { return sets_.find(a) == sets_.find(b); }
  /// Tells whether it is joined with no other.
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
