#pragma once

#include "meshalyzer/set/set_object.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// How much of an object lies inside another one, where their faces do not cross.
enum class Inclusion : std::uint8_t {
  None,
  /// Some of its components, but not all.
  Partly,
  Wholly,
};

/// How two objects lie to each other.
struct ObjectMeeting {
  /// All pairs of faces that share a point; face_a is a file face of the first object, face_b one
  /// of the second. Ascending.
  std::vector<IntersectingPair> pairs;
  Inclusion first_in_second = Inclusion::None;
  Inclusion second_in_first = Inclusion::None;
};

/// Finds out how two objects lie to each other; exact.
///
/// Where faces cross, neither includes the other. Where they only touch, an object is included when
/// all its vertices that are not on the other's surface are inside, and there are such.
///
/// @complexity O(faces whose boxes meet the other object); where they touch also a ray a vertex.
[[nodiscard]] ObjectMeeting find_meeting(const SetObject& first, const SetObject& second);

}  // namespace meshalyzer
