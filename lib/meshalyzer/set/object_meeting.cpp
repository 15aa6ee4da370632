#include "meshalyzer/set/object_meeting.h"

#include "meshalyzer/spatial/mutual_intersection.h"

#include <utility>

namespace meshalyzer {
namespace {

bool contains(const Box3& outer, const Box3& inner) {
  return !inner.isEmpty() && outer.contains(inner);
}

/// Returns the inclusion of objects that do not touch: each component is inside or outside as a
/// whole, as is any of its vertices.
Inclusion inclusion_apart(const SetObject& inner, const SetObject& outer) {
  std::size_t n_inside = 0;
  for (std::size_t c = 0; c < inner.components().count; ++c) {
    const Vec3& point = inner.tree().point(inner.component_vertices()[c]);
    const bool may_be = contains(outer.box(), inner.component_boxes()[c]);
    n_inside += may_be && outer.side_of(point) == Side::Inside ? 1 : 0;
  }
  return n_inside == 0                          ? Inclusion::None
         : n_inside == inner.components().count ? Inclusion::Wholly
                                                : Inclusion::Partly;
}

/// Returns the inclusion of objects that touch without crossing.
Inclusion inclusion_touching(const SetObject& inner, const SetObject& outer) {
  if (!outer.is_solid() || !contains(outer.box(), inner.box())) {
    return Inclusion::None;
  }
  bool any_inside = false;
  for (const Index vertex : inner.used_vertices()) {
    const Side side = outer.side_of(inner.tree().point(vertex));
    if (side == Side::Outside) return Inclusion::None;
    any_inside = any_inside || side == Side::Inside;
  }
  return any_inside ? Inclusion::Wholly : Inclusion::None;
}

}  // namespace

ObjectMeeting find_meeting(const SetObject& first, const SetObject& second,
                           const PairLimits& limits) {
  ObjectMeeting meeting;
  if (!first.box().intersects(second.box())) {
    return meeting;
  }
  FoundPairs found =
      count_intersections(first.cut(), first.tree(), second.cut(), second.tree(), limits);
  meeting.pairs = std::move(found.listed);
  meeting.counts = found.counts;
  meeting.is_search_stopped = !found.is_complete;
  if (meeting.is_search_stopped) {
    return meeting;
  }
  if (meeting.counts.total() == 0) {
    meeting.first_in_second = inclusion_apart(first, second);
    meeting.second_in_first = inclusion_apart(second, first);
  } else if (meeting.counts.of(ContactKind::Crossing) == 0) {
    meeting.first_in_second = inclusion_touching(first, second);
    meeting.second_in_first = inclusion_touching(second, first);
  }
  return meeting;
}

}  // namespace meshalyzer
