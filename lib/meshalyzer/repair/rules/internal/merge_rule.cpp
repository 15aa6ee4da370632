#include "meshalyzer/repair/rules/internal/merge_rule.h"

#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/repair/rules/internal/orientation_rule.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

/// A side of an affected face, named by the representatives of its vertices.
struct JoinedSide {
  /// The higher end; the lower one names the bucket.
  Index end = 0;
  Index third = 0;
  /// 3 k + i: side i of affected face k.
  Index side = 0;

  friend bool operator<(const JoinedSide& a, const JoinedSide& b) {
    return std::tie(a.end, a.third, a.side) < std::tie(b.end, b.third, b.side);
  }
};

class MergeCheck {
 public:
  MergeCheck(const Soup& soup, std::span<const Index> representative,
             std::span<const Index> affected)
      : soup_(soup),
        representative_(representative),
        affected_(affected),
        rejections_(representative.size()) {}

  [[nodiscard]] std::vector<MergeRejection> run() {
    for (const Index f : affected_) look_at_face(soup_.triangles[f]);
    look_at_edges();
    return any_ ? std::move(rejections_) : std::vector<MergeRejection>();
  }

 private:
  [[nodiscard]] Triangle joined(const Triangle& t) const {
    return {representative_[t[0]], representative_[t[1]], representative_[t[2]]};
  }

  void reject(Index representative, MergeRejection rejection) {
    rejections_[representative] = rejection;
    any_ = true;
  }

  void look_at_face(const Triangle& before) {
    const Triangle after = joined(before);
    if (!is_in_complex(after)) {
      for (const Index v : after) reject(v, MergeRejection::Collapse);
      return;
    }
    std::array<bool, 3> moves{};
    for (std::size_t i = 0; i < 3; ++i) {
      moves[i] = soup_.positions[before[i]] != soup_.positions[after[i]];
    }
    const bool moves_any = moves[0] || moves[1] || moves[2];
    if (!moves_any || keeps_orientation(corners_of(soup_.positions, before),
                                        corners_of(soup_.positions, after))) {
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (moves[i]) reject(after[i], MergeRejection::TurnOver);
    }
  }

  /// Sorts the sides into buckets by their lower end, and examines those of each edge together.
  void look_at_edges() {
    const ItemsByGroup sides(representative_.size(), [&](const auto& use) {
      for (Index k = 0; k < affected_.size(); ++k) {
        const Triangle t = joined(soup_.triangles[affected_[k]]);
        if (!is_in_complex(t)) continue;
        for (Index i = 0; i < 3; ++i) use(std::min(t[i], t[(i + 1) % 3]), 3 * k + i);
      }
    });
    std::vector<JoinedSide> bucket;
    for (Index lower = 0; lower < sides.size(); ++lower) {
      bucket.clear();
      for (const Index side : sides[lower]) bucket.push_back(joined_side(side));
      std::sort(bucket.begin(), bucket.end());
      for_each_run(std::span<const JoinedSide>(bucket), &JoinedSide::end,
                   [&](std::span<const JoinedSide> edge) { look_at_edge(lower, edge); });
    }
  }

  [[nodiscard]] JoinedSide joined_side(Index side) const {
    const Triangle t = joined(soup_.triangles[affected_[side / 3]]);
    const Index i = side % 3;
    return {.end = std::max(t[i], t[(i + 1) % 3]), .third = t[(i + 2) % 3], .side = side};
  }

  void look_at_edge(Index lower, std::span<const JoinedSide> sides) {
    bool was_one_edge = true;
    for (std::size_t i = 1; i < sides.size(); ++i) {
      was_one_edge = was_one_edge && old_edge(sides[i].side) == old_edge(sides[0].side);
      if (sides[i].third == sides[i - 1].third &&
          old_corners(sides[i].side) != old_corners(sides[i - 1].side)) {
        for (const Index v : {lower, sides[i].end, sides[i].third}) {
          reject(v, MergeRejection::Duplicate);
        }
      }
    }
    if (was_one_edge || sides.size() <= 2) return;
    for (const Index v : {lower, sides[0].end}) reject(v, MergeRejection::NonManifold);
  }

  [[nodiscard]] std::array<Index, 2> old_edge(Index side) const {
    const Triangle& t = soup_.triangles[affected_[side / 3]];
    const auto [a, b] = std::minmax(t[side % 3], t[(side + 1) % 3]);
    return {a, b};
  }

  [[nodiscard]] Triangle old_corners(Index side) const {
    return sorted_corners(soup_.triangles[affected_[side / 3]]);
  }

  const Soup& soup_;
  std::span<const Index> representative_;
  std::span<const Index> affected_;
  std::vector<MergeRejection> rejections_;
  bool any_ = false;
};

}  // namespace

std::string_view reason_of(MergeRejection rejection) {
  switch (rejection) {
    case MergeRejection::None:
      return "";
    case MergeRejection::Collapse:
      return "joining them would collapse a face";
    case MergeRejection::TurnOver:
      return "joining them would turn a face over";
    case MergeRejection::NonManifold:
      return "joining them would make an edge with more than two faces";
    case MergeRejection::Duplicate:
      return "joining them would make two faces with the same vertices";
  }
  return "";
}

std::vector<MergeRejection> check_merges(const Soup& soup, std::span<const Index> representative,
                                         std::span<const Index> affected) {
  return MergeCheck(soup, representative, affected).run();
}

}  // namespace meshalyzer
