#pragma once

#include <meshalyzer/mesh/tri_mesh.h>
#include <optional>

/// Exercise 5: Gaussian and mean curvature at a vertex. See 5_curvature.md.
namespace lab {

using meshalyzer::TriMesh;
using meshalyzer::Vec3;
using meshalyzer::VertexHandle;

/// Exercise 5 a: 2 pi minus the angles of the faces round a vertex that is not on a border.
double angle_defect(const TriMesh& mesh, VertexHandle vertex);

/// Exercise 5 b: the area of all faces round a vertex: the laboratory report's A of equation (5).
double one_ring_area(const TriMesh& mesh, VertexHandle vertex);

/// Exercise 5 c: the Voronoi area, by the cotangent formula; may be negative at obtuse faces.
double voronoi_area(const TriMesh& mesh, VertexHandle vertex);

/// Exercise 5 d: equation (5) with the Voronoi area; nothing on a border, without faces, and where
/// the area is not positive.
std::optional<double> gaussian_curvature(const TriMesh& mesh, VertexHandle vertex);

/// Exercise 5 e: the sum of (cot alpha + cot beta)(v_i - v_j) over the neighbours v_j.
Vec3 cotangent_vector(const TriMesh& mesh, VertexHandle vertex);

/// Exercise 5 f: equation (7), with a sign: positive where the surface bends away from its
/// normals, as a sphere with outward normals does. Nothing where there is no Gaussian curvature.
std::optional<double> mean_curvature(const TriMesh& mesh, VertexHandle vertex);

}  // namespace lab
