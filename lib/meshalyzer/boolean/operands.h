#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <span>
#include <vector>

namespace meshalyzer {

/// The solids that a boolean operation combines: the faces of one soup, each of which belongs to
/// one of them. Only refers to the soup.
struct Operands {
  const Soup& soup;
  /// #faces: the number of the operand that each belongs to, below `count`.
  std::vector<Index> of_face;
  std::size_t count = 0;
};

/// Puts several meshes into one soup, one behind the other: records, missing references, groups and
/// normals. Ids are 1, 2, ..., n then, and where groups of several meshes come together, faces that
/// belong to none are in one without a name.
[[nodiscard]] Soup concatenate(std::span<const Soup> meshes);

/// Returns the meshes of a soup that concatenate() has made, each an operand.
[[nodiscard]] Operands operands_of(const Soup& all, std::span<const Soup> meshes);

/// Returns the solids of one mesh, each an operand, in order of their lowest faces: its components,
/// but a shell that is the wall of a cavity belongs to the solid that it is a cavity of, or
/// crosses.
///
/// @complexity  As PreparedMesh::shells().
[[nodiscard]] Operands operands_of(const Soup& soup);

/// Returns the volume that each operand encloses: what it goes round n times counts n times.
///
/// @complexity O(#F).
[[nodiscard]] std::vector<double> volumes_of(const Operands& operands);

}  // namespace meshalyzer
