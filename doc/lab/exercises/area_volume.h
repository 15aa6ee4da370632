#pragma once

#include <meshalyzer/mesh/tri_mesh.h>
#include <optional>

/// Exercise 4: area and volume. See 4_area_and_volume.md.
namespace lab {

using meshalyzer::FaceHandle;
using meshalyzer::TriMesh;
using meshalyzer::Vec3;

/// Exercise 4 a: the area of a face.
double face_area(const TriMesh& mesh, FaceHandle face);

/// Exercise 4 b: equation (2): the area of the surface.
double surface_area(const TriMesh& mesh);

/// Exercise 4 c: equation (4): the volume that a closed surface encloses, negative where its
/// normals point inwards; nothing where it is not closed.
std::optional<double> volume(const TriMesh& mesh);

}  // namespace lab
