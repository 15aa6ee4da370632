#include "meshalyzer/topology/boundary.h"

#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace meshalyzer {
namespace {

/// The two ends of a half-edge.
enum class End : std::uint8_t { From, To };

End other(End end) {
  return end == End::From ? End::To : End::From;
}

/// One end of a border edge, which its inner half-edge names.
struct EdgeEnd {
  HalfedgeHandle halfedge;
  End end = End::To;
};

/// Walks from border edge to border edge through the fans between them.
class BorderWalk {
 public:
  explicit BorderWalk(const CutMesh& cut)
      : cut_(cut), kinds_(classify_edges(cut)), visited_(cut.mesh.n_edges(), 0) {
    const CutEdges& flipped = cut.side.flipped_edges;
    if (flipped.size() == 0) return;
    twins_.resize(cut.mesh.n_edges());
    for (std::size_t i = 0; i < flipped.size(); ++i) {
      const auto pair = flipped[i].halfedges;
      twins_[edge(pair[0])] = pair[1];
      twins_[edge(pair[1])] = pair[0];
    }
  }

  [[nodiscard]] bool is_visited(HalfedgeHandle h) const { return visited_[edge(h)] != 0; }

  /// Walks on from an end of a border edge until a loop is closed or a chain ends, and marks the
  /// edges as visited.
  ///
  /// @param walk  The edges are appended to it, beginning with the first one itself.
  BoundaryShape walk_from(EdgeEnd start, std::vector<HalfedgeHandle>& walk) {
    std::optional<EdgeEnd> at = start;
    do {
      visited_[edge(at->halfedge)] = 1;
      walk.push_back(at->halfedge);
      at = across_fan(*at);
      if (at) at->end = other(at->end);
    } while (at && at->halfedge != start.halfedge);
    return at ? BoundaryShape::Loop : BoundaryShape::Chain;
  }

 private:
  [[nodiscard]] std::size_t edge(HalfedgeHandle h) const {
    return static_cast<std::size_t>(cut_.mesh.edge_handle(h).idx());
  }

  /// Returns the border edge at the other side of the fan that begins with a border edge at one of
  /// its ends, and which of its own ends lies there; nothing where a non-manifold edge ends the
  /// fan.
  [[nodiscard]] std::optional<EdgeEnd> across_fan(EdgeEnd at) const {
    const TriMesh& mesh = cut_.mesh;
    for (;;) {
      // Continue with the other edge of the same face at the same vertex.
      at.halfedge = at.end == End::To ? mesh.next_halfedge_handle(at.halfedge)
                                      : mesh.prev_halfedge_handle(at.halfedge);
      at.end = other(at.end);
      switch (kinds_[edge(at.halfedge)]) {
        case EdgeKind::Border:
          return at;
        case EdgeKind::NonManifold:
          return std::nullopt;
        case EdgeKind::Inner:
          at.halfedge = mesh.opposite_halfedge_handle(at.halfedge);
          at.end = other(at.end);
          break;
        case EdgeKind::Flipped:
          // Both faces cross the edge in the same direction: the end stays the same.
          at.halfedge = twins_[edge(at.halfedge)];
          break;
      }
    }
  }

  const CutMesh& cut_;
  std::vector<EdgeKind> kinds_;
  /// #mesh edges: the half-edge of the other face of a flipped edge. Empty where no edge is
  /// flipped.
  std::vector<HalfedgeHandle> twins_;
  std::vector<std::uint8_t> visited_;
};

/// Appends the boundary that an unvisited border edge is on.
void trace(BorderWalk& border, HalfedgeHandle lowest, BoundaryLoops& loops) {
  std::vector<HalfedgeHandle>& all = loops.halfedges;
  const auto first = static_cast<std::ptrdiff_t>(all.size());
  const BoundaryShape shape = border.walk_from({lowest, End::To}, all);
  if (shape == BoundaryShape::Chain) {
    // The walk began in the middle of a chain: it is repeated after the edges before it.
    all.resize(static_cast<std::size_t>(first));
    border.walk_from({lowest, End::From}, all);
    std::reverse(all.begin() + first, all.end());
    all.pop_back();
    border.walk_from({lowest, End::To}, all);
  }
  loops.begin.push_back(static_cast<Index>(all.size()));
  loops.shapes.push_back(shape);
}

}  // namespace

BoundaryLoops find_boundary_loops(const CutMesh& cut) {
  return find_boundary_loops(cut, find_border_edges(cut));
}

BoundaryLoops find_boundary_loops(const CutMesh& cut,
                                  std::span<const HalfedgeHandle> border_edges) {
  BoundaryLoops loops;
  if (border_edges.empty()) return loops;
  // Each border edge is on one boundary.
  loops.halfedges.reserve(border_edges.size());
  BorderWalk border(cut);
  for (const HalfedgeHandle h : border_edges) {
    if (!border.is_visited(h)) trace(border, h, loops);
  }
  return loops;
}

}  // namespace meshalyzer
