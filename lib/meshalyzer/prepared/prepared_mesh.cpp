#include "meshalyzer/prepared/prepared_mesh.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/geometry/volume.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/prepared/internal/intersection_counter.h"
#include "meshalyzer/spatial/self_intersection.h"

#include <utility>

namespace meshalyzer {
namespace {

/// Returns a non-owning pointer to a soup.
std::shared_ptr<const Soup> borrow(const Soup& soup) {
  return {std::shared_ptr<const Soup>(), &soup};
}

}  // namespace

PreparedMesh::PreparedMesh(const Soup& soup, PairLimits pair_limits)
    : PreparedMesh(borrow(soup), std::move(pair_limits)) {}

PreparedMesh::PreparedMesh(std::shared_ptr<const Soup> soup, PairLimits pair_limits)
    : soup_(std::move(soup)),
      cut_(build(PreparedMesh::soup())),
      pair_limits_(std::move(pair_limits)) {}

const Soup& PreparedMesh::soup() const {
  if (!soup_) throw InvalidArgument("the records are null, or were released");
  return *soup_;
}

const FaceTree& PreparedMesh::tree() const {
  return tree_.get([this] {
    require_finite_positions(cut_.mesh);
    return FaceTree(cut_);
  });
}

const Components& PreparedMesh::components() const {
  return components_.get([this] { return find_components(cut_); });
}

const std::vector<Box3>& PreparedMesh::component_boxes() const& {
  return component_boxes_.get([this] {
    const Components& parts = components();
    return bounding_boxes(cut_.mesh, {.of_face = parts.of_face, .count = parts.count});
  });
}

std::vector<Box3> PreparedMesh::component_boxes() && {
  static_cast<void>(std::as_const(*this).component_boxes());
  return component_boxes_.take();
}

const std::vector<IntersectingPair>& PreparedMesh::intersecting_pairs() const& {
  return found_pairs().listed;
}

std::vector<IntersectingPair> PreparedMesh::intersecting_pairs() && {
  static_cast<void>(std::as_const(*this).intersecting_pairs());
  return pairs_.take().listed;
}

void PreparedMesh::set_intersecting_pairs(std::vector<IntersectingPair> pairs) {
  static_cast<void>(pairs_.get([&] {
    FoundPairs found;
    found.counts.add(pairs);
    found.listed = std::move(pairs);
    return found;
  }));
}

const FoundPairs& PreparedMesh::found_pairs() const {
  return pairs_.get([this] { return search_intersecting_pairs(); });
}

const IntersectionCounts& PreparedMesh::intersection_counts() const {
  const FoundPairs& found = found_pairs();
  return intersection_counts_.get([&] {
    return count_intersecting_pairs([&](PairListener& counter) {
      counter.on_pairs(found.listed);
      return found.is_complete;
    });
  });
}

/// Searches the pairs. If the list is shorter than the search is long, they are counted as they are
/// found.
FoundPairs PreparedMesh::search_intersecting_pairs() const {
  const bool lists_all = pair_limits_.max_listed >= pair_limits_.max_found;
  PairLimits limits = pair_limits_;
  if (lists_all) limits.max_listed = limits.max_found;
  // Only one pair more tells that those found are not all.
  if (limits.max_found != kAllPairs) ++limits.max_found;
  FoundPairs found;
  if (lists_all) {
    found = find_self_intersections(cut_, tree(), limits);
  } else {
    static_cast<void>(intersection_counts_.get([&] {
      return count_intersecting_pairs([&](PairListener& counter) {
        found = find_self_intersections(cut_, tree(), limits, &counter);
        return found.is_complete;
      });
    }));
  }
  found.is_complete = found.is_complete && found.counts.total() <= pair_limits_.max_found;
  return found;
}

/// @param visit  Passes on the pairs, and returns whether these are all.
IntersectionCounts PreparedMesh::count_intersecting_pairs(
    const std::function<bool(PairListener&)>& visit) const {
  const std::vector<std::uint8_t> is_shell = which_are_shells(cut_, components());
  IntersectionCounter counter({.side = cut_.side,
                               .components = components(),
                               .is_shell = is_shell,
                               .boxes = component_boxes()});
  const bool is_complete = visit(counter);
  IntersectionCounts counts = counter.take();
  counts.is_complete = is_complete;
  return counts;
}

const std::vector<Shell>& PreparedMesh::shells() const& {
  return shells_.get([this] {
    require_finite_positions(cut_.mesh);
    return find_shells(*this);
  });
}

std::vector<Shell> PreparedMesh::shells() && {
  static_cast<void>(std::as_const(*this).shells());
  return shells_.take();
}

}  // namespace meshalyzer
