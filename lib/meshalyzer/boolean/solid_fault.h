#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>

namespace meshalyzer {

/// Says why a mesh bounds no solid, so that no boolean operation can take it: "it is not closed: 4
/// edges have one face only". Empty where it does.
///
/// A solid has faces, whose corners are all defined; these cross every edge equally often in both
/// directions, and no shell is inside out but one that crosses others, which takes away from what
/// they enclose. It may intersect itself, and need not be manifold.
///
/// @complexity O(#F log #F), and as PreparedMesh::shells() where there are several components.
[[nodiscard]] std::string find_solid_fault(const Soup& soup);

}  // namespace meshalyzer
