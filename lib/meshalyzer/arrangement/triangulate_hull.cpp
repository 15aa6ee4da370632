#include "meshalyzer/arrangement/triangulate_hull.h"

#include <utility>

namespace meshalyzer {
namespace {

/// Builds a triangulation and its hull point by point.
class HullSweep {
 public:
  HullSweep(Axis dropped, std::vector<const ExactPoint*> points) {
    t_.dropped = dropped;
    t_.points = std::move(points);
    t_.leaving.assign(t_.points.size(), kNoIndex);
    ahead_.assign(t_.points.size(), kNoIndex);
    behind_ = ahead_;
    rim_ = ahead_;
  }

  Triangulation run() {
    const auto n = static_cast<Index>(t_.points.size());
    for (Index p = start(); p < n; ++p) add(p);
    return std::move(t_);
  }

 private:
  /// Joins the first, collinear points to the first point off their line.
  /// @return  The point after it.
  Index start() {
    Index apex = 2;
    Sign side = 0;
    while ((side = t_.turn(0, 1, apex)) == 0) ++apex;
    Index before = kNoIndex;
    for (Index p = 0; p + 1 < apex; ++p) {
      const Index h = side > 0 ? t_.add_triangle(p, p + 1, apex) : t_.add_triangle(p + 1, p, apex);
      set_rim(p, p + 1, h, side);
      // If the apex is to the left of p, p + 1, the edge from the apex to p comes last; else that
      // from p comes second.
      const Index near = side > 0 ? h + 2 : h + 1;
      if (before != kNoIndex) t_.link(before, near);
      if (p == 0) set_rim(apex, 0, near, side);
      before = side > 0 ? h + 1 : h + 2;
    }
    set_rim(apex - 1, apex, before, side);
    return apex + 1;
  }

  /// Makes the edge from `from` to `to` one of the hull, with the hull on its left; if the side is
  /// negative, the edge from `to` to `from`.
  void set_rim(Index from, Index to, Index halfedge, Sign side) {
    if (side < 0) std::swap(from, to);
    ahead_[from] = to;
    behind_[to] = from;
    rim_[from] = halfedge;
  }

  /// Joins a point after all others to the part of the hull that it sees, which begins at the last
  /// point.
  void add(Index p) {
    Index front = p - 1;
    Index joint = kNoIndex;  // the half-edge from p to `front`
    while (t_.turn(front, ahead_[front], p) < 0) {
      const Index to = ahead_[front];
      const Index h = t_.add_triangle(front, p, to);
      t_.link(h + 2, rim_[front]);
      if (joint != kNoIndex) t_.link(h, joint);
      if (front == p - 1) first_ = h;
      joint = h + 1;
      front = to;
    }
    const Index joint_ahead = joint;
    Index back = p - 1;
    joint = joint_ahead == kNoIndex ? kNoIndex : first_;  // the half-edge from `back` to p
    while (t_.turn(behind_[back], back, p) < 0) {
      const Index from = behind_[back];
      const Index h = t_.add_triangle(from, p, back);
      t_.link(h + 2, rim_[from]);
      if (joint != kNoIndex) {
        t_.link(h + 1, joint);
      } else {
        first_ = h + 1;
      }
      joint = h;
      back = from;
    }
    set_rim(back, p, joint, 1);
    set_rim(p, front, joint_ahead != kNoIndex ? joint_ahead : first_, 1);
  }

  Triangulation t_;
  /// #vertices: for those on the hull the next one, counter-clockwise.
  std::vector<Index> ahead_;
  std::vector<Index> behind_;
  std::vector<Index> rim_;
  /// The first half-edge that joins the point being added to the last one, on the hull's side.
  Index first_ = kNoIndex;
};

}  // namespace

Triangulation triangulate_hull(Axis dropped, std::vector<const ExactPoint*> points) {
  return HullSweep(dropped, std::move(points)).run();
}

}  // namespace meshalyzer
