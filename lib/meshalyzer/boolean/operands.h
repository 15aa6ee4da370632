#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// The solids that a boolean operation combines: the faces of one soup, each of which belongs to
/// one of them. The struct only refers to the soup.
struct Operands {
  const Soup& soup;
  /// #faces: the number of the operand that each belongs to, below `count`.
  std::vector<Index> of_face;
  std::size_t count = 0;
};

/// Concatenates meshes: records, missing references, groups and normals. Ids become 1, 2, ..., n.
/// If several meshes have groups, faces without one are put into a group without a name.
/// @throws InvalidArgument  as build() for each mesh.
[[nodiscard]] Soup concatenate(std::span<const Soup> meshes);

/// Returns the meshes that concatenate() has joined, each as an operand.
[[nodiscard]] Operands operands_of(const Soup& all, std::span<const Soup> meshes);

/// Returns the solids of one mesh, each an operand, in order of their lowest faces: its components,
/// except that the wall of a cavity belongs to the solid that contains the cavity, or that the wall
/// crosses.
///
/// @throws InvalidArgument  as build(); and if a position is not finite.
/// @complexity  That of PreparedMesh::shells().
[[nodiscard]] Operands operands_of(const Soup& soup);

/// Returns the volume that each operand encloses; space that it goes round n times counts n times.
///
/// @complexity O(#F).
[[nodiscard]] std::vector<double> volumes_of(const Operands& operands);

}  // namespace meshalyzer
