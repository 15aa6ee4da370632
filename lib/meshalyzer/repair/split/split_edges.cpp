#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/split/cut_stars.h"
#include "meshalyzer/repair/split/edge_strands.h"
#include "meshalyzer/repair/split/vertex_stars.h"
#include "meshalyzer/topology/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Finds out which fans the pairs of strands leave at each vertex (Guéziec et al. 2001, "Cutting
/// and stitching: converting sets of polygons to manifold surfaces").
class EdgeCutter {
 public:
  explicit EdgeCutter(const PassInput& input)
      : input_(input),
        soup_(input.mesh.soup()),
        strands_(list_strands(input.mesh.cut())),
        stars_(input.mesh.cut(), ends_of_strands(strands_)),
        partner_(pair_strands(input.mesh, strands_, stars_)),
        fans_(stars_.n_places(), 0) {}

  [[nodiscard]] PassResult cut() {
    PassResult result;
    for (std::size_t star = 0; star < stars_.size(); ++star) find_fans(star);
    for (std::size_t edge = 0; edge < strands_.size(); ++edge) {
      if (is_held(edge)) {
        result.refused.push_back(
            {.code = DefectCode::NonManifold,
             .vertex = strands_.ends[edge][0],
             .face = strands_.faces[strands_.begin[edge]],
             .reason = "the border of a face of the body would get more edges"});
      } else {
        take_apart(edge);
      }
    }
    result.edits = cut_stars(soup_, stars_, fans_, connected_stars());
    return result;
  }

 private:
  /// Whether a vertex must not get copies.
  [[nodiscard]] bool is_fixed(Index vertex) const {
    return input_.limits.groups == Groups::Faces && input_.limits.is_fixed(input_.draft, vertex);
  }
  /// Whether an edge cannot be split, for neither of its ends can.
  [[nodiscard]] bool is_held(std::size_t edge) const {
    return is_fixed(strands_.ends[edge][0]) && is_fixed(strands_.ends[edge][1]);
  }

  /// Numbers the fans of a star, as strands are paired now.
  void find_fans(std::size_t star) {
    const Index v = stars_.vertex(star);
    if (is_fixed(v)) return;
    const auto join = [&](std::span<const Spoke> spokes) {
      const Index begin = strands_.begin[strands_.edge_between(v, spokes.front().other)];
      std::vector<Index> partner;
      for (Index i = 0; i < spokes.size(); ++i) {
        const Index other = partner_[begin + i];
        partner.push_back(other == kNoIndex ? kNoIndex : other - begin);
      }
      return partner;
    };
    const std::vector<Index> fans = find_fans_of_star(soup_, stars_, star, join);
    std::copy(fans.begin(), fans.end(),
              fans_.begin() + static_cast<std::ptrdiff_t>(stars_.begin(star)));
  }

  /// The fans that a strand is in at the two ends of its edge: the vertices that it will have.
  [[nodiscard]] std::array<Index, 2> new_ends(Index strand) const {
    std::array<Index, 2> fans{};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t star = stars_.star_of(strands_.ends[strands_.edge_of[strand]][i]);
      fans[i] = fans_[stars_.begin(star) + stars_.place(star, strands_.faces[strand])];
    }
    return fans;
  }

  /// Where pairs of an edge come together again at both its ends, so that both would be between the
  /// same two vertices, lets their faces go. Each then goes on with that to which it leads round
  /// the ends: fans have two rims, so no three faces stay together, and fans only get smaller.
  void take_apart(std::size_t edge) {
    std::vector<std::pair<std::array<Index, 2>, Index>> by_ends;
    for (Index strand = strands_.begin[edge]; strand < strands_.begin[edge + 1]; ++strand) {
      by_ends.emplace_back(new_ends(strand), strand);
    }
    std::sort(by_ends.begin(), by_ends.end());
    bool has_changed = false;
    for (std::size_t first = 0; first < by_ends.size();) {
      std::size_t last = first;
      while (last < by_ends.size() && by_ends[last].first == by_ends[first].first) ++last;
      if (last - first > 2) {
        for (std::size_t i = first; i < last; ++i) let_go(by_ends[i].second);
        has_changed = true;
      }
      first = last;
    }
    if (!has_changed) return;
    for (const Index v : strands_.ends[edge]) find_fans(stars_.star_of(v));
  }

  void let_go(Index strand) {
    if (partner_[strand] != kNoIndex) partner_[partner_[strand]] = kNoIndex;
    partner_[strand] = kNoIndex;
  }

  /// Stars at the two ends of an edge belong together.
  [[nodiscard]] DisjointSets connected_stars() const {
    DisjointSets connected(stars_.size());
    for (const auto& [a, b] : strands_.ends) {
      connected.unite(static_cast<Index>(stars_.star_of(a)), static_cast<Index>(stars_.star_of(b)));
    }
    return connected;
  }

  const PassInput& input_;
  const Soup& soup_;
  EdgeStrands strands_;
  VertexStars stars_;
  /// #strands: see pair_strands().
  std::vector<Index> partner_;
  /// By place in all stars.
  std::vector<Index> fans_;
};

}  // namespace

PassResult split_edges(const PassInput& input) {
  if (input.mesh.cut().side.non_manifold_edges.size() == 0) return {};
  return EdgeCutter(input).cut();
}

}  // namespace meshalyzer
