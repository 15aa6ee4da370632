#include "meshalyzer/repair/cut/internal/closed_part.h"

#include "meshalyzer/arrangement/exact_ray.h"
#include "meshalyzer/arrangement/windings.h"
#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/repair/cut/internal/face_edges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// #faces: 1 for those that form closed chains with the faces that they are connected to by edges.
std::vector<std::uint8_t> faces_of_closed_chains(const Soup& soup,
                                                 const std::vector<FaceEdge>& edges) {
  DisjointSets chains(soup.n_faces());
  std::vector<Index> open_at;
  for_each_run(std::span(edges), &FaceEdge::ends, [&](std::span<const FaceEdge> edge) {
    int sum = 0;
    for (const FaceEdge& side : edge) {
      chains.unite(edge[0].face, side.face);
      sum += side.sign;
    }
    if (sum != 0) open_at.push_back(edge[0].face);
  });
  std::vector<std::uint8_t> is_open(soup.n_faces(), 0);
  for (const Index face : open_at) is_open[chains.find(face)] = 1;
  std::vector<std::uint8_t> is_closed(soup.n_faces());
  for (Index face = 0; face < soup.n_faces(); ++face) {
    is_closed[face] = is_open[chains.find(face)] == 0 ? 1 : 0;
  }
  return is_closed;
}

/// The numbers of edges of a component, and of those that have one face only.
struct EdgeCounts {
  std::size_t all = 0;
  std::size_t border = 0;
};

/// #components.
std::vector<EdgeCounts> count_edges(const ArrangedSoup& arranged,
                                    const std::vector<FaceEdge>& edges) {
  std::vector<EdgeCounts> counts(arranged.cells.n_components);
  for_each_run(std::span(edges), &FaceEdge::ends, [&](std::span<const FaceEdge> edge) {
    Index component = kNoIndex;
    for (const FaceEdge& side : edge) {
      if (component == kNoIndex) component = arranged.component_of_face(side.face);
    }
    if (component == kNoIndex) return;
    EdgeCounts& count = counts[component];
    ++count.all;
    if (edge.size() == 1) ++count.border;
  });
  return counts;
}

/// Finds the winding numbers of closed chains, as if the sheets were not there.
class ClosedPartSearch {
 public:
  ClosedPartSearch(const ArrangedSoup& arranged, std::span<const std::uint8_t> wanted)
      : a_(arranged), wanted_(wanted), windings_(arranged.cells) {
    const std::vector<FaceEdge> edges = sorted_edges(a_.soup.triangles);
    is_closed_face_ = faces_of_closed_chains(a_.soup, edges);
    for (const EdgeCounts& count : count_edges(a_, edges)) {
      has_border_.push_back(count.border > 0 ? 1 : 0);
      result_.is_loose.push_back(2 * count.border > count.all ? 1 : 0);
    }
    result_.tells_inside.assign(a_.cells.n_components, 0);
    for (Index piece = 0; piece < a_.arrangement.pieces.size(); ++piece) {
      result_.is_of_chain.push_back(is_of_closed_chain(piece) ? 1 : 0);
    }
  }

  ClosedPart run() {
    // A ray must cross the faces of components that are not closed as a whole, too.
    Cells cells = a_.cells;
    for (std::size_t c = 0; c < wanted_.size(); ++c) {
      if (wanted_[c] != 0) cells.is_closed[c] = 1;
    }
    const ArrangedSoup with_rays{a_.soup, a_.cut, a_.tree, a_.arrangement, cells};
    for (Index piece = 0; piece < a_.arrangement.pieces.size(); ++piece) {
      const Index component = a_.cells.component_of[piece];
      if (wanted_[component] == 0 || result_.is_of_chain[piece] == 0) continue;
      if (std::exchange(result_.tells_inside[component], 1) == 0) begin_at(piece, with_rays);
    }
    result_.windings = windings_.of_cell();
    result_.encloses_rest = result_.tells_inside;
    for (Index piece = 0; piece < a_.arrangement.pieces.size(); ++piece) {
      const bool is_inside = result_.windings[a_.cells.front(piece)] >= 1;
      const Index component = a_.cells.component_of[piece];
      if (is_inside || result_.is_of_chain[piece] != 0) continue;
      result_.encloses_rest[component] = 0;
      if (has_border_[component] == 0) result_.tells_inside[component] = 0;
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_of_closed_chain(Index piece) const {
    const auto sources = a_.arrangement.sources_of(piece);
    return std::any_of(sources.begin(), sources.end(), [&](const PieceSource& source) {
      return is_closed_face_[source.face] != 0;
    });
  }

  /// Returns how often closed chains cover a piece.
  [[nodiscard]] int multiplicity(Index piece) const {
    int sum = 0;
    for (const PieceSource& source : a_.arrangement.sources_of(piece)) {
      if (is_closed_face_[source.face] != 0) sum += source.sign;
    }
    return sum;
  }

  void begin_at(Index piece, const ArrangedSoup& with_rays) {
    const PieceRay ray = follow_ray(with_rays, piece);
    const Index component = a_.cells.component_of[piece];
    int own = 0;
    int others = 0;
    for (const auto& [face, sign] : ray.crossings) {
      if (is_closed_face_[face] == 0) continue;
      (a_.component_of_face(face) == component ? own : others) += sign;
    }
    windings_.spread_from(ray.cell, own + (others > 0 ? 1 : 0),
                          [&](Index p) { return multiplicity(p); });
  }

  const ArrangedSoup& a_;
  std::span<const std::uint8_t> wanted_;
  /// #faces: 1 for those of closed chains.
  std::vector<std::uint8_t> is_closed_face_;
  /// #components: 1 for those with an edge that has one face only.
  std::vector<std::uint8_t> has_border_;
  CellWindings windings_;
  ClosedPart result_;
};

}  // namespace

ClosedPart find_closed_part(const ArrangedSoup& arranged, std::span<const std::uint8_t> wanted) {
  if (std::none_of(wanted.begin(), wanted.end(), [](auto is_wanted) { return is_wanted != 0; })) {
    const std::vector<std::uint8_t> none(arranged.cells.n_components, 0);
    return {none, none, none, std::vector<int>(arranged.cells.count, 0),
            std::vector<std::uint8_t>(arranged.arrangement.pieces.size(), 0)};
  }
  return ClosedPartSearch(arranged, wanted).run();
}

}  // namespace meshalyzer
