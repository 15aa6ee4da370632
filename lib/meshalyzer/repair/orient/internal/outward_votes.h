#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/topology/components.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// The part that a region takes in a vote on which way regions point.
enum class RegionRole : std::uint8_t {
  /// It is closed, and which way it points is known otherwise.
  Shell,
  /// Its faces vote.
  Voter,
  /// The region takes no part.
  None,
};

/// The input of vote_outward(). This holds references only.
struct OutwardQuery {
  const PreparedMesh& mesh;
  /// The regions as find_oriented_regions() returns them.
  const Components& regions;
  /// #regions.
  std::span<const RegionRole> roles;
};

/// Finds the regions that point the wrong way by winding numbers: those that bound a solid, and
/// clearly have it on the wrong side.
///
/// Each region is judged by its own winding number alone, and how many others are round it does not
/// depend on how they are oriented: so all may be turned at once, or some, and asked again nothing
/// is turned. Inside an odd number of others, none of which it crosses, a region is the wall of a
/// cavity.
///
/// @return #regions: 1 for those to be turned.
[[nodiscard]] std::vector<std::uint8_t> vote_outward(const OutwardQuery& query);

}  // namespace meshalyzer
