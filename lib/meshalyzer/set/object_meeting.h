#pragma once

#include "meshalyzer/set/set_object.h"
#include "meshalyzer/spatial/pair_limits.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// Tells how much of an object lies inside another one, where their faces do not cross.
enum class Inclusion : std::uint8_t {
  None,
  /// Some of its components, but not all.
  Partly,
  Wholly,
};

/// Tells how two objects lie to each other.
struct ObjectMeeting {
  /// The pairs of faces that share a point, at most PairLimits::max_listed; face_a is a file face
  /// of the first object, face_b one of the second. Ascending.
  std::vector<IntersectingPair> pairs;
  /// The number of all of them, listed or not.
  ContactCounts counts;
  /// Tells whether the search was told to stop before its end.
  bool is_search_stopped = false;
  Inclusion first_in_second = Inclusion::None;
  Inclusion second_in_first = Inclusion::None;
};

/// Finds out how two objects lie to each other; exact.
///
/// Where faces cross, neither includes the other. Where they only touch, an object is included when
/// all its vertices that are not on the other's surface are inside, and there are such.
///
/// @param limits  How many pairs are listed, and when the search ends; then nothing is known of
/// inclusions.
/// @complexity O(faces whose boxes meet the other object); where they touch also a ray a vertex.
[[nodiscard]] ObjectMeeting find_meeting(const SetObject& first, const SetObject& second,
                                         const PairLimits& limits = {});

}  // namespace meshalyzer
