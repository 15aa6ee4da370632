#pragma once

#include "meshalyzer/mesh/tri_mesh.h"

#include <vector>

namespace meshalyzer {

// Private to the geometry module.

/// Normals good enough to be differentiated: at each vertex that of a quadric through it which fits
/// its neighbours and theirs (the idea of Garimella and Swartz 2003, "Curvature estimation for
/// unstructured triangulations of surfaces", with another basis and weights).
///
/// An average of face normals is wrong by the order of an edge length where the mesh is irregular,
/// and curvatures made from such do not get better as the mesh gets finer. These normals are wrong
/// by the order of its square. In the frame of the normal given, (x, y, z), the fit is
///
///     z = p x + q y + a (x^2 - y^2) + b x y + c (x^2 + y^2 + z^2),
///
/// weighted by 1 / distance; with z^2 in it, spheres are among what is fitted exactly.
///
/// A vertex keeps the normal given where it has more than 16 neighbours, fewer than six points
/// round it face the same side, or these lie so far from any quadric that the slopes p and q have
/// a standard error of 0.2 or more; and at sizes whose fourth power no double can hold.
///
/// @param normals  #mesh vertices, of length 1, or zero for none.
/// @return         #mesh vertices. Spheres keep the normals given if these are right.
/// @complexity     O(#V).
[[nodiscard]] std::vector<Vec3> fitted_normals(const TriMesh& mesh,
                                               const std::vector<Vec3>& normals);

}  // namespace meshalyzer
