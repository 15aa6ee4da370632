#include "meshalyzer/arrangement/segment_crossings.h"

#include "meshalyzer/spatial/box_tree.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {
namespace {

/// Up to this number of segments, all pairs are tested.
constexpr std::size_t kFewSegments = 16;
/// After so many segments the search asks whether to stop.
constexpr std::size_t kSegmentsBetweenQuestions = 64;

/// Searches the crossings among the segments of one cluster.
class Crossings {
 public:
  Crossings(std::span<const FaceSimplex> simplices, const FaceCluster& cluster,
            const NamedPoints& points, std::size_t max_found)
      : simplices_(simplices), axis_(cluster.axis), points_(points), max_found_(max_found) {
    for (const ClusterSegment& s : cluster.segments) {
      if (s.line == SegmentLine::Edge || s.from == s.to) continue;
      segments_.push_back(s);
      // Rounding is monotone: if segments meet, so do their boxes.
      Box3 box(points_[s.from].rounded);
      box.extend(points_[s.to].rounded);
      boxes_.push_back(box);
    }
  }

  std::vector<PointName> find(const StopQuery& wants_to_stop) {
    if (segments_.size() <= kFewSegments) {
      for (std::size_t i = 0; i < segments_.size(); ++i) {
        for (std::size_t j = i + 1; j < segments_.size(); ++j) {
          if (boxes_[i].intersects(boxes_[j])) look_at(segments_[i], segments_[j]);
        }
      }
      return std::move(found_);
    }
    const BoxTree tree(boxes_);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (i % kSegmentsBetweenQuestions == 0 && wants_to_stop()) break;
      if (found_.size() > max_found_) break;
      for (const Index j : tree.meeting(boxes_[i])) {
        if (j > i) look_at(segments_[i], segments_[j]);
      }
    }
    return std::move(found_);
  }

 private:
  void look_at(const ClusterSegment& s, const ClusterSegment& t) {
    const bool joined = s.from == t.from || s.from == t.to || s.to == t.from || s.to == t.to;
    if (!joined && separates(s, t) && separates(t, s)) found_.push_back(crossing(s, t));
  }

  [[nodiscard]] bool separates(const ClusterSegment& s, const ClusterSegment& t) const {
    const Sign first = side(s, t.from);
    return first != 0 && first * side(s, t.to) < 0;
  }

  [[nodiscard]] Sign side(const ClusterSegment& s, Index point) const {
    return orient2d(axis_, points_[s.from], points_[s.to], points_[point]);
  }

  [[nodiscard]] PointName crossing(const ClusterSegment& s, const ClusterSegment& t) const {
    if (s.line == SegmentLine::Face) {
      return t.line == SegmentLine::Face ? two_lines_name(ends(s), ends(t), axis_)
                                         : line_and_plane_name(ends(s), t.other);
    }
    return t.line == SegmentLine::Face ? line_and_plane_name(ends(t), s.other)
                                       : three_planes_name({s.face, s.other, t.other});
  }

  [[nodiscard]] VertexPair ends(const ClusterSegment& s) const {
    return simplices_[simplex_number(simplices_, s.other)].ends;
  }

  std::span<const FaceSimplex> simplices_;
  Axis axis_;
  const NamedPoints& points_;
  std::size_t max_found_;
  std::vector<ClusterSegment> segments_;
  std::vector<Box3> boxes_;
  std::vector<PointName> found_;
};

}  // namespace

std::vector<PointName> find_segment_crossings(std::span<const FaceSimplex> simplices,
                                              const FaceCluster& cluster, const NamedPoints& points,
                                              std::size_t max_found,
                                              const StopQuery& wants_to_stop) {
  return Crossings(simplices, cluster, points, max_found).find(wants_to_stop);
}

}  // namespace meshalyzer
