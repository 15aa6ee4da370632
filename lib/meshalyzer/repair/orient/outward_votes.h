#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/topology/components.h"

#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {

/// What becomes of a patch when which way it points is voted.
enum class PatchRole : std::uint8_t {
  /// It is closed, and which way it points is known otherwise.
  Shell,
  /// It is asked.
  Voter,
  /// Neither.
  None,
};

/// What vote_outward() needs to be found before; only refers to it.
struct OutwardBallot {
  const PreparedMesh& mesh;
  /// As find_oriented_patches() returns them.
  const Components& patches;
  /// #patches.
  std::span<const PatchRole> roles;
};

/// Tells which patches point the wrong way, as winding numbers have it: those that mean a solid,
/// and clearly have it on the wrong side of them.
///
/// Each patch is asked by its own winding number alone, and how many others are round it does not
/// depend on how they are oriented: so all may be turned at once, or some, and asked again nothing
/// is turned. Inside an odd number of others, none of which it crosses, a patch is the wall of a
/// cavity.
///
/// @return #patches: 1 for those to be turned.
[[nodiscard]] std::vector<std::uint8_t> vote_outward(const OutwardBallot& ballot);

}  // namespace meshalyzer
