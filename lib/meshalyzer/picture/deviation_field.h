#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/picture/field.h"
#include "meshalyzer/prepared/prepared_mesh.h"

namespace meshalyzer {

/// Measures how far a mesh is from another one, such as a mesh before a repair from that after it.
///
/// Unlike the deviation that a repair must keep, it counts the patches of holes too, and looks at
/// the vertices only.
///
/// @param soup   The mesh that the field is of.
/// @param other  The mesh that it is compared with. Its tree is used.
/// @return       The field `deviation`: the distance of each vertex that is drawn from the surface
///               of the other mesh. The others have no value, nor has any if that has no face.
/// @complexity   O(#V log #F of the other mesh) on average, and O(#F).
[[nodiscard]] Field deviation_field(const Soup& soup, const PreparedMesh& other);

}  // namespace meshalyzer
