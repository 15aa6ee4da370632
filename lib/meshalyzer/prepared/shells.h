#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/topology/components.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

class PreparedMesh;

/// Describes a component as the wall of a solid. Only a shell is such a wall: a component that is
/// closed, manifold and consistently oriented.
struct Shell {
  /// The signed volume; absent where the component is no shell, or the volume is too large for a
  /// double.
  std::optional<double> volume;
  /// Tells whether it points away from the solid: its volume is positive and an even number of
  /// shells enclose it, or negative and an odd number do. Nothing where it is no shell or encloses
  /// no volume.
  std::optional<bool> outward;
  /// The shell that directly encloses the component; kNoIndex where none does.
  Index inside = kNoIndex;
};

/// Tells which components are shells.
///
/// @param components  As find_components() returns them.
/// @return            #components: 1 for shells.
/// @complexity        O(#E).
[[nodiscard]] std::vector<std::uint8_t> which_are_shells(const CutMesh& cut,
                                                         const Components& components);

/// Finds the volume of each component, whether it points outward, and which shell directly encloses
/// it; directions and enclosures are exact. Components that cross do not enclose each other. Where
/// the search for intersecting pairs was told to stop, nothing is known but the volumes.
///
/// PreparedMesh::shells() keeps what this returns.
///
/// @return     One a component.
/// @complexity As find_nesting(), which is called where there are several components and shells
/// among them.
[[nodiscard]] std::vector<Shell> find_shells(const PreparedMesh& mesh);

}  // namespace meshalyzer
