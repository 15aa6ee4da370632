#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>

namespace meshalyzer {

/// Returns the reason why a mesh bounds no solid and cannot be an operand, such as "it is not
/// closed: 4 edges have one face only". The text is empty if it bounds one.
///
/// A solid has faces, whose corners are all defined; they cross every edge equally often in both
/// directions, and no shell is inside out except one that crosses others and subtracts from what
/// they enclose. It may intersect itself, and need not be manifold.
///
/// @throws InvalidArgument  as build().
/// @complexity O(#F log #F), plus that of PreparedMesh::shells() if there are several components.
[[nodiscard]] std::string find_solid_fault(const Soup& soup);

}  // namespace meshalyzer
