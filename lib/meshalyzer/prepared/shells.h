#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/topology/components.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

class PreparedMesh;

/// A component as the wall of a solid. Only a shell is such a wall: a component that is closed,
/// manifold and consistently oriented.
struct Shell {
  /// The signed volume; absent if the component is no shell, or the volume is too large for a
  /// double.
  std::optional<double> volume;
  /// Tells whether it points away from the solid: its volume is positive and an even number of
  /// shells enclose it, or negative and an odd number do. Absent if it is no shell or encloses no
  /// volume.
  std::optional<bool> outward;
  /// The shell that directly encloses the component; kNoIndex if none does.
  Index inside = kNoIndex;
};

/// Tells which components are shells.
///
/// @param components  The result of find_components().
/// @return            #components: 1 for shells.
/// @complexity        O(#E).
[[nodiscard]] std::vector<std::uint8_t> which_are_shells(const CutMesh& cut,
                                                         const Components& components);

/// Finds the volume of each component, whether it points outward, and which shell directly encloses
/// it; directions and enclosures are exact. Components that cross do not enclose each other. If not
/// all intersecting pairs were searched, only the volumes are known.
///
/// PreparedMesh::shells() keeps the result.
///
/// @return     One shell for each component.
/// @complexity That of find_nesting(), which is called if there are several components and shells
///             among them.
[[nodiscard]] std::vector<Shell> find_shells(const PreparedMesh& mesh);

}  // namespace meshalyzer
