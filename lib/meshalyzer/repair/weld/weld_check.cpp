#include "meshalyzer/repair/weld/weld_check.h"

#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/repair/weld/weld_edges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

namespace meshalyzer {
namespace {

/// A side of a touched face by the vertices that stay.
struct JoinedSide {
  /// The higher end; the lower one names the bucket.
  Index end = 0;
  Index third = 0;
  /// 3 k + i: side i of touched face k.
  Index side = 0;

  friend bool operator<(const JoinedSide& a, const JoinedSide& b) {
    return std::tie(a.end, a.third, a.side) < std::tie(b.end, b.third, b.side);
  }
};

class HarmSearch {
 public:
  HarmSearch(const Soup& soup, std::span<const Index> staying, std::span<const Index> touched)
      : soup_(soup), staying_(staying), touched_(touched), harms_(staying.size()) {}

  [[nodiscard]] std::vector<WeldHarm> run() {
    for (const Index f : touched_) look_at_face(soup_.triangles[f]);
    look_at_edges();
    return any_ ? std::move(harms_) : std::vector<WeldHarm>();
  }

 private:
  [[nodiscard]] Triangle joined(const Triangle& t) const {
    return {staying_[t[0]], staying_[t[1]], staying_[t[2]]};
  }

  void blame(Index staying, WeldHarm harm) {
    harms_[staying] = harm;
    any_ = true;
  }

  void look_at_face(const Triangle& before) {
    const Triangle after = joined(before);
    if (!is_in_complex(after)) {
      for (const Index v : after) blame(v, WeldHarm::Collapse);
      return;
    }
    std::array<bool, 3> moves{};
    for (std::size_t i = 0; i < 3; ++i) {
      moves[i] = !at_one_place(soup_.positions[before[i]], soup_.positions[after[i]]);
    }
    if (!(moves[0] || moves[1] || moves[2]) || faces_one_way(before, after)) return;
    for (std::size_t i = 0; i < 3; ++i) {
      if (moves[i]) blame(after[i], WeldHarm::TurnOver);
    }
  }

  /// Whether both face to the same side, seen along an axis that shows the first well. A face
  /// without area may become what it likes.
  [[nodiscard]] bool faces_one_way(const Triangle& before, const Triangle& after) const {
    const std::vector<Vec3>& p = soup_.positions;
    const std::optional<Axis> axis = projection_axis(p[before[0]], p[before[1]], p[before[2]]);
    return !axis || orient2d(*axis, p[before[0]], p[before[1]], p[before[2]]) ==
                        orient2d(*axis, p[after[0]], p[after[1]], p[after[2]]);
  }

  /// Sorts the sides into buckets by their lower end, and looks at those of each edge together.
  void look_at_edges() {
    std::vector<Index> begin(staying_.size() + 1, 0);
    for_each_side([&](Index lower, const JoinedSide&) { ++begin[lower]; });
    Index sum = 0;
    for (Index& b : begin) b = sum += b;
    std::vector<JoinedSide> sides(sum);
    for_each_side([&](Index lower, const JoinedSide& side) { sides[--begin[lower]] = side; });
    for (std::size_t lower = 0; lower + 1 < begin.size(); ++lower) {
      const auto bucket = std::span(sides).subspan(begin[lower], begin[lower + 1] - begin[lower]);
      std::sort(bucket.begin(), bucket.end());
      look_at_bucket(static_cast<Index>(lower), bucket);
    }
  }

  template <typename Visit>
  void for_each_side(Visit&& visit) const {
    for (std::size_t k = 0; k < touched_.size(); ++k) {
      const Triangle t = joined(soup_.triangles[touched_[k]]);
      if (!is_in_complex(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = t[i];
        const Index b = t[(i + 1) % 3];
        visit(std::min(a, b), JoinedSide{.end = std::max(a, b),
                                         .third = t[(i + 2) % 3],
                                         .side = static_cast<Index>(3 * k + i)});
      }
    }
  }

  void look_at_bucket(Index lower, std::span<const JoinedSide> bucket) {
    for (std::size_t begin = 0; begin < bucket.size();) {
      std::size_t end = begin + 1;
      while (end < bucket.size() && bucket[end].end == bucket[begin].end) ++end;
      look_at_edge(lower, bucket.subspan(begin, end - begin));
      begin = end;
    }
  }

  void look_at_edge(Index lower, std::span<const JoinedSide> sides) {
    bool was_one_edge = true;
    for (std::size_t i = 1; i < sides.size(); ++i) {
      was_one_edge = was_one_edge && old_edge(sides[i].side) == old_edge(sides[0].side);
      if (sides[i].third == sides[i - 1].third &&
          old_corners(sides[i].side) != old_corners(sides[i - 1].side)) {
        for (const Index v : {lower, sides[i].end, sides[i].third}) blame(v, WeldHarm::Duplicate);
      }
    }
    if (was_one_edge || sides.size() <= 2) return;
    for (const Index v : {lower, sides[0].end}) blame(v, WeldHarm::NonManifold);
  }

  [[nodiscard]] std::array<Index, 2> old_edge(Index side) const {
    const Triangle& t = soup_.triangles[touched_[side / 3]];
    const auto [a, b] = std::minmax(t[side % 3], t[(side + 1) % 3]);
    return {a, b};
  }

  [[nodiscard]] Triangle old_corners(Index side) const {
    Triangle t = soup_.triangles[touched_[side / 3]];
    std::sort(t.begin(), t.end());
    return t;
  }

  const Soup& soup_;
  std::span<const Index> staying_;
  std::span<const Index> touched_;
  std::vector<WeldHarm> harms_;
  bool any_ = false;
};

}  // namespace

std::string_view reason_of(WeldHarm harm) {
  switch (harm) {
    case WeldHarm::None:
      return "";
    case WeldHarm::Collapse:
      return "joining them would collapse a face";
    case WeldHarm::TurnOver:
      return "joining them would turn a face over";
    case WeldHarm::NonManifold:
      return "joining them would make an edge with more than two faces";
    case WeldHarm::Duplicate:
      return "joining them would make two faces with the same vertices";
  }
  return "";
}

std::vector<WeldHarm> find_weld_harms(const Soup& soup, std::span<const Index> staying,
                                      std::span<const Index> touched) {
  return HarmSearch(soup, staying, touched).run();
}

}  // namespace meshalyzer
