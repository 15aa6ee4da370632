#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/topology/components.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// What find_shells() needs to be found before; only refers to it.
struct ShellsInput {
  const CutMesh& cut;
  /// Over the faces of `cut`.
  const FaceTree& tree;
  /// As find_components() returns them.
  const Components& components;
  /// #components: 1 for those that are closed, manifold and consistent, the shells.
  std::span<const std::uint8_t> is_shell;
  /// #components, as bounding_boxes() returns them.
  std::span<const Box3> boxes;
  /// The intersecting pairs of the mesh: components that cross do not enclose each other. Not
  /// needed where there is only one component.
  std::span<const IntersectingPair> pairs;
};

/// What a component is as the wall of a solid.
struct Shell {
  /// Nothing where it is no shell, or the volume is too large for a double.
  std::optional<double> volume;
  /// Whether it points away from the solid: its volume is positive and an even number of others
  /// enclose it, or negative and an odd number do. Nothing where it is no shell or encloses no
  /// volume.
  std::optional<bool> outward;
  /// The component that directly encloses it; kNoIndex: none.
  Index inside = kNoIndex;
};

/// Finds of every component whether it points outward, and which one directly encloses it, both
/// exactly.
///
/// @return One a component.
/// @complexity As find_nesting().
[[nodiscard]] std::vector<Shell> find_shells(const ShellsInput& input);

/// The same for a mesh that is already built.
///
/// @param is_shell  As which_are_shells() returns it.
[[nodiscard]] std::vector<Shell> find_shells(const PreparedMesh& mesh, const Components& components,
                                             std::span<const std::uint8_t> is_shell);

/// Tells which components are closed, manifold and consistent.
///
/// @param components  As find_components() returns them.
/// @return            #components: 1 for those that are.
/// @complexity        O(#E).
[[nodiscard]] std::vector<std::uint8_t> which_are_shells(const CutMesh& cut,
                                                         const Components& components);

}  // namespace meshalyzer
