#pragma once

#include "meshalyzer/mesh/tri_mesh.h"

#include <vector>

namespace meshalyzer {

// Private to the geometry module.

/// Computes normals that are accurate enough to be differentiated: at each vertex the normal of a
/// quadric through it that fits the vertices within two edges (the idea of Garimella and Swartz
/// 2003, "Curvature estimation for unstructured triangulations of surfaces", with another basis and
/// weights).
///
/// On an irregular mesh the error of averaged face normals is of the order of an edge length, so
/// curvatures computed from them do not improve as the mesh gets finer. The error of these normals
/// is of the order of its square. In the frame (x, y, z) of the given normal the fit is
///
///     z = p x + q y + a (x^2 - y^2) + b x y + c (x^2 + y^2 + z^2),
///
/// weighted by 1 / distance; because of the term z^2 it reproduces spheres exactly.
///
/// A vertex keeps the given normal if it has more than 16 neighbours, if fewer than six points
/// round it face the same side, if these lie so far from any quadric that the slopes p and q have a
/// standard error of 0.2 or more, or if the fourth power of the size is not a finite, non-zero
/// double.
///
/// @param normals  #mesh vertices: the unit normals, zero for none.
/// @return         #mesh vertices: the normals. Spheres keep the given normals if these are right.
/// @complexity     O(#V).
[[nodiscard]] std::vector<Vec3> fitted_normals(const TriMesh& mesh,
                                               const std::vector<Vec3>& normals);

}  // namespace meshalyzer
