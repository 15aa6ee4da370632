#include "meshalyzer/arrangement/plane_cover.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace meshalyzer {
namespace {

/// Traverses the triangles, beginning at the hull.
class CoverSearch {
 public:
  CoverSearch(const Triangulation& triangulation, std::vector<BorderEdge> borders)
      : t_(triangulation), borders_(std::move(borders)) {
    std::sort(borders_.begin(), borders_.end());
    cover_.set_of.assign(t_.n_triangles(), kNoIndex);
    cover_.sets.emplace_back();
  }

  PlaneCover run() {
    for (Index h = 0; h < t_.origin.size(); ++h) {
      if (t_.twin[h] == kNoIndex) {
        enter(h, 0);
        spread();
      }
    }
    return std::move(cover_);
  }

 private:
  /// Enters the triangle of h across its edge, coming from a triangle that this set of faces
  /// covers.
  void enter(Index h, Index set) {
    if (cover_.set_of[h / 3] != kNoIndex) return;
    cover_.set_of[h / 3] = t_.constrained[h] != 0 ? across(h, set) : set;
    pending_.push_back(h / 3);
  }

  void spread() {
    while (!pending_.empty()) {
      const Index triangle = pending_.back();
      pending_.pop_back();
      for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (t_.twin[h] != kNoIndex) enter(t_.twin[h], cover_.set_of[triangle]);
      }
    }
  }

  /// Returns the set of faces that covers the other side of an edge.
  Index across(Index h, Index set) {
    const auto [low, high] = std::minmax({t_.origin[h], t_.target(h)});
    const std::array<Index, 2> ends{low, high};
    const auto begin = std::lower_bound(borders_.begin(), borders_.end(), BorderEdge{ends, 0});
    if (begin == borders_.end() || begin->ends != ends) return set;
    const std::vector<Index>& old = cover_.sets[set];
    std::vector<Index> crossed;
    for (auto edge = begin; edge != borders_.end() && edge->ends == ends; ++edge) {
      crossed.push_back(edge->face);
    }
    std::vector<Index> next;
    std::set_symmetric_difference(old.begin(), old.end(), crossed.begin(), crossed.end(),
                                  std::back_inserter(next));
    cover_.sets.push_back(std::move(next));
    return static_cast<Index>(cover_.sets.size() - 1);
  }

  const Triangulation& t_;
  std::vector<BorderEdge> borders_;
  PlaneCover cover_;
  std::vector<Index> pending_;
};

}  // namespace

PlaneCover cover_by_borders(const Triangulation& triangulation, std::vector<BorderEdge> borders) {
  return CoverSearch(triangulation, std::move(borders)).run();
}

}  // namespace meshalyzer
