#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/repair/pass.h"

#include <vector>

namespace meshalyzer {

/// The components that become thin shells before a union.
struct ShellChoice {
  /// The components of these faces, by key, if they are open; ascending.
  std::vector<Index> face_keys;
  /// Tells whether they become shells even if they are closed.
  bool closed_too = false;
  /// The open components in whose box one of these points lies: their hole patches may hide it.
  std::vector<Vec3> hidden_points;
  /// Faces, by key, ascending, that need not be joined to the rest of their shell, see thicken().
  std::vector<Index> separable_keys = {};
  /// The thickness of the shells, as a share of the maximum deviation.
  double thickness_share = 0.5;
};

/// The faces of the components that are chosen, and of others.
struct ChosenShells {
  /// The keys of all faces that become shells, ascending.
  std::vector<Index> face_keys;
  /// The keys of all faces of other open components, ascending.
  std::vector<Index> other_open_keys;
};

/// Finds the components that a choice makes shells.
///
/// @complexity O(#F log #F + #components #points).
[[nodiscard]] ChosenShells choose_shells(const PassInput& input, const ShellChoice& choice);

}  // namespace meshalyzer
