#pragma once

#include "meshalyzer/set/set_object.h"
#include "meshalyzer/spatial/pair_limits.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// How much of an object lies inside another one whose faces do not cross it.
enum class Inclusion : std::uint8_t {
  None,
  /// Some of its components are inside, but not all.
  Partly,
  Wholly,
};

/// The relation between two objects.
struct ObjectMeeting {
  /// The pairs of faces that share a point, at most PairLimits::max_listed; face_a is a file face
  /// of the first object, face_b one of the second. Ascending.
  std::vector<IntersectingPair> pairs;
  /// The number of all pairs, listed or not.
  ContactCounts counts;
  /// Tells whether the search was stopped before its end.
  bool is_search_stopped = false;
  Inclusion first_in_second = Inclusion::None;
  Inclusion second_in_first = Inclusion::None;
};

/// Finds the relation between two objects, exactly.
///
/// If faces cross, neither object includes the other. If they only touch, an object is included if
/// at least one of its vertices is not on the other's surface and all such vertices are inside.
///
/// @param limits  The limits of the list and of the search; if the search is stopped, inclusions
///                are unknown.
/// @complexity O(faces whose boxes meet the other object), plus a ray per vertex if they touch.
[[nodiscard]] ObjectMeeting find_meeting(const SetObject& first, const SetObject& second,
                                         const PairLimits& limits = {});

}  // namespace meshalyzer
