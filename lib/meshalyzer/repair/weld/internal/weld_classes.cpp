#include "meshalyzer/repair/weld/internal/weld_classes.h"

#include "meshalyzer/repair/rules/internal/merge_rule.h"

#include <array>
#include <numeric>
#include <utility>

namespace meshalyzer {

std::vector<Index> count_faces_at_vertices(const Soup& soup) {
  std::vector<Index> counts(soup.n_vertices(), 0);
  for (const Triangle& t : soup.triangles) {
    if (!is_in_complex(t)) continue;
    for (const Index v : t) ++counts[v];
  }
  return counts;
}

bool is_preferred(const WeldRules& rules, Index a, Index b) {
  const PassInput& input = rules.input;
  const bool a_is_fixed = input.limits.is_fixed(input.tracked, a);
  const bool b_is_fixed = input.limits.is_fixed(input.tracked, b);
  if (a_is_fixed != b_is_fixed) return a_is_fixed;
  const Index a_faces = rules.faces_at_vertices[a];
  const Index b_faces = rules.faces_at_vertices[b];
  return a_faces != b_faces ? a_faces > b_faces : a < b;
}

WeldClasses::WeldClasses(const WeldRules& rules)
    : rules_(rules),
      sets_(rules.input.tracked.soup.n_vertices()),
      next_(rules.input.tracked.soup.n_vertices()) {
  std::iota(next_.begin(), next_.end(), Index{0});
  representative_ = next_;
}

std::string_view WeldClasses::join(const WeldEdge& a, const WeldEdge& b, EdgeRun run) {
  constexpr std::string_view kTooFar = "their ends would have to move too far";
  const std::array<Index, 2> of_a{sets_.find(a.from), sets_.find(a.to)};
  const std::array<Index, 2> of_b{sets_.find(partner_of_from(b, run)),
                                  sets_.find(partner_of_to(b, run))};
  if (of_a[0] == of_a[1] || of_b[0] == of_b[1] || of_a[0] == of_b[1] || of_b[0] == of_a[1]) {
    return reason_of(MergeRejection::Collapse);
  }
  for (const WeldEdge* edge : {&a, &b}) {
    const Index third = sets_.find(edge->third);
    for (const auto& ends : {of_a, of_b}) {
      if (third == ends[0] || third == ends[1]) return reason_of(MergeRejection::Collapse);
    }
  }
  if (!may_join(of_a[0], of_b[0]) || !may_join(of_a[1], of_b[1])) return kTooFar;
  unite(of_a[0], of_b[0]);
  unite(of_a[1], of_b[1]);
  return {};
}

std::vector<Index> WeldClasses::representatives() {
  std::vector<Index> representative(next_.size());
  for (Index v = 0; v < representative.size(); ++v) {
    representative[v] = representative_[sets_.find(v)];
  }
  return representative;
}

/// Tells whether two sets, given by their roots, may be joined.
bool WeldClasses::may_join(Index a, Index b) {
  if (a == b) return true;
  const bool a_stays = is_preferred(rules_, representative_[a], representative_[b]);
  return a_stays ? can_go(b, representative_[a]) : can_go(a, representative_[b]);
}

/// Tells whether all of a set can move to the position of a vertex.
bool WeldClasses::can_go(Index root, Index to) const {
  const PassInput& input = rules_.input;
  const std::vector<Vec3>& positions = input.tracked.soup.positions;
  // All members can move to the position of the present representative.
  if (positions[representative_[root]] == positions[to]) return true;
  if (input.limits.is_fixed(input.tracked, representative_[root])) return false;
  Index v = root;
  do {
    if (!((positions[v] - positions[to]).stableNorm() <= rules_.reach)) return false;
    v = next_[v];
  } while (v != root);
  return true;
}

void WeldClasses::unite(Index a, Index b) {
  if (a == b) return;
  const bool a_stays = is_preferred(rules_, representative_[a], representative_[b]);
  const Index representative = a_stays ? representative_[a] : representative_[b];
  std::swap(next_[a], next_[b]);
  sets_.unite(a, b);
  representative_[sets_.find(a)] = representative;
}

}  // namespace meshalyzer
