#pragma once

#include <meshalyzer/mesh/tri_mesh.h>

/// Exercise 3: normals of faces and vertices. See 3_normals.md.
///
/// OpenMesh's circulators are allowed from here on: mesh.fv_range(face), mesh.vf_range(vertex).
namespace lab {

using meshalyzer::FaceHandle;
using meshalyzer::TriMesh;
using meshalyzer::Vec3;
using meshalyzer::VertexHandle;

/// Exercise 3 a: the unit normal of a face, on the side from which its corners run
/// counter-clockwise; zero where its area is zero.
Vec3 face_normal(const TriMesh& mesh, FaceHandle face);

/// Exercise 3 b: equation (1): the sum of the unit normals of the faces round a vertex, made of
/// length 1; zero where the sum is.
Vec3 vertex_normal(const TriMesh& mesh, VertexHandle vertex);

/// Exercise 3 c: the same, each face counted by its angle at the vertex.
Vec3 angle_weighted_normal(const TriMesh& mesh, VertexHandle vertex);

}  // namespace lab
