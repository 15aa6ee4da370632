#include "meshalyzer/arrangement/insert_segment.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <span>

namespace meshalyzer {
namespace {

/// A half-edge and its ends, by which it is ordered.
struct DirectedEdge {
  std::array<Index, 2> ends;
  Index halfedge = kNoIndex;
  bool constrained = false;

  friend bool operator<(const DirectedEdge& a, const DirectedEdge& b) { return a.ends < b.ends; }
};

/// Inserts a segment into a triangulation, from vertex to vertex.
class SegmentInsertion {
 public:
  SegmentInsertion(Triangulation& triangulation, Index to) : t_(triangulation), to_(to) {}

  /// Makes an edge from a vertex to the next one on the segment, and returns that vertex.
  Index advance(Index from) {
    from_ = from;
    t_.collect_leaving(from, leaving_);
    for (const Index h : leaving_) {
      if (const Index end = along(h); end != kNoIndex) return end;
    }
    for (const Index h : leaving_) {
      const Index right = t_.target(h);
      const Index left = t_.origin[Triangulation::previous(h)];
      if (side(right) < 0 && side(left) > 0) return cross(Triangulation::next(h));
    }
    assert(false);
    return to_;
  }

 private:
  [[nodiscard]] Sign side(Index vertex) const { return t_.turn(from_, to_, vertex); }

  /// Tells whether a vertex on the line of the segment lies ahead. Vertices are sorted along any
  /// line.
  [[nodiscard]] bool is_ahead(Index vertex) const { return (vertex > from_) == (to_ > from_); }

  /// Constrains one of the two edges that leave the vertex in the triangle of h if it lies along
  /// the segment.
  Index along(Index h) {
    const Index previous = Triangulation::previous(h);
    for (const Index edge : {h, previous}) {
      const Index end = edge == h ? t_.target(h) : t_.origin[previous];
      if (end == to_ || (is_ahead(end) && side(end) == 0)) {
        t_.constrain(edge);
        return end;
      }
    }
    return kNoIndex;
  }

  /// Replaces the triangles that the segment crosses until it meets a vertex.
  /// @param edge  The first edge crossed, in the triangle that the segment begins in.
  Index cross(Index edge) {
    right_ = {from_, t_.origin[edge]};
    left_ = {from_, t_.target(edge)};
    removed_ = {edge / 3};
    for (;;) {
      assert(t_.constrained[edge] == 0);
      edge = t_.twin[edge];
      removed_.push_back(edge / 3);
      const Index apex = t_.origin[Triangulation::previous(edge)];
      const Sign turn = apex == to_ ? 0 : side(apex);
      if (turn == 0) {
        left_.push_back(apex);
        right_.push_back(apex);
        retriangulate();
        return apex;
      }
      (turn > 0 ? left_ : right_).push_back(apex);
      edge = turn > 0 ? Triangulation::next(edge) : Triangulation::previous(edge);
    }
  }

  void retriangulate() {
    collect_border();
    slots_ = removed_;
    made_.clear();
    triangulate_side(left_, 1);
    triangulate_side(right_, -1);
    link_made();
  }

  /// Collects the edges round the removed triangles, seen from outside.
  void collect_border() {
    std::sort(removed_.begin(), removed_.end());
    border_.clear();
    for (const Index triangle : removed_) {
      for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        border_.push_back({{t_.origin[h], t_.target(h)}, outer(h), t_.constrained[h] != 0});
      }
    }
    std::sort(border_.begin(), border_.end());
  }

  /// Returns the twin of a half-edge unless it is removed.
  [[nodiscard]] Index outer(Index h) const {
    const Index twin = t_.twin[h];
    const bool stays =
        twin != kNoIndex && !std::binary_search(removed_.begin(), removed_.end(), twin / 3);
    return stays ? twin : kNoIndex;
  }

  /// Triangulates the polygon between a chain and the segment by cutting ears. This must not be the
  /// EarCutter of holes: the corners are exact points that no double holds, and each of them sees
  /// the segment, so that each convex corner is an ear and one pass with a stack cuts them all.
  /// @param side  The side of the segment on which the chain lies.
  void triangulate_side(std::span<const Index> chain, Sign side) {
    stack_.clear();
    for (const Index vertex : chain) {
      while (stack_.size() > 1) {
        const Index tip = stack_.back();
        const Index base = stack_[stack_.size() - 2];
        if (t_.turn(base, tip, vertex) * side >= 0) break;
        side > 0 ? make(base, vertex, tip) : make(base, tip, vertex);
        stack_.pop_back();
      }
      stack_.push_back(vertex);
    }
    assert(stack_.size() == 2);
  }

  void make(Index a, Index b, Index c) {
    const Index h = 3 * slots_.back();
    slots_.pop_back();
    const std::array<Index, 3> corners{a, b, c};
    for (Index i = 0; i < 3; ++i) {
      t_.origin[h + i] = corners[i];
      t_.leaving[corners[i]] = h + i;
      made_.push_back({{corners[i], corners[(i + 1) % 3]}, h + i});
    }
  }

  /// Links the new triangles to each other and to their neighbours.
  void link_made() {
    std::sort(made_.begin(), made_.end());
    for (const DirectedEdge& edge : made_) {
      const Index h = edge.halfedge;
      const DirectedEdge* const old = find(border_, edge.ends);
      t_.constrained[h] = old != nullptr && old->constrained ? 1 : 0;
      const DirectedEdge* const inner = find(made_, {edge.ends[1], edge.ends[0]});
      if (inner != nullptr) {
        t_.twin[h] = inner->halfedge;
      } else {
        t_.twin[h] = kNoIndex;
        t_.link(h, old->halfedge);
      }
    }
    t_.constrain(find(made_, {left_.front(), left_.back()})->halfedge);
  }

  static const DirectedEdge* find(const std::vector<DirectedEdge>& edges,
                                  const std::array<Index, 2>& ends) {
    const auto found = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{ends});
    return found != edges.end() && found->ends == ends ? &*found : nullptr;
  }

  Triangulation& t_;
  Index to_;
  Index from_ = kNoIndex;
  std::vector<Index> leaving_;
  /// The vertices on the left of this part of the segment, including its ends.
  std::vector<Index> left_;
  std::vector<Index> right_;
  std::vector<Index> removed_;
  std::vector<Index> slots_;
  std::vector<Index> stack_;
  std::vector<DirectedEdge> border_;
  std::vector<DirectedEdge> made_;
};

}  // namespace

std::vector<Index> insert_segment(Triangulation& triangulation, Index from, Index to) {
  std::vector<Index> vertices{from};
  SegmentInsertion insertion(triangulation, to);
  while (vertices.back() != to) vertices.push_back(insertion.advance(vertices.back()));
  return vertices;
}

}  // namespace meshalyzer
