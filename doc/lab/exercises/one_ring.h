#pragma once

#include <meshalyzer/mesh/tri_mesh.h>
#include <vector>

/// Exercise 2: walk round a vertex. See 2_one_rings.md.
///
/// Take single steps only: next_halfedge_handle, prev_halfedge_handle, opposite_halfedge_handle,
/// to_vertex_handle, face_handle, is_boundary(halfedge). OpenMesh's own ranges and circulators
/// (vv_range, vf_iter, ...) would be the solution itself.
namespace lab {

using meshalyzer::FaceHandle;
using meshalyzer::HalfedgeHandle;
using meshalyzer::TriMesh;
using meshalyzer::VertexHandle;

/// Exercise 2 a: the half-edges that start at a vertex, counter-clockwise.
///
/// On the border the first is the one whose pair has no face, so that none is left out; the last
/// is the one that has no face itself. Inside a surface any may be the first. Empty where no face
/// uses the vertex: mesh.halfedge_handle(vertex) is not valid there.
std::vector<HalfedgeHandle> outgoing_halfedges(const TriMesh& mesh, VertexHandle vertex);

/// Exercise 2 b: the vertices at the other ends of these, in the same order.
std::vector<VertexHandle> one_ring_vertices(const TriMesh& mesh, VertexHandle vertex);

/// Exercise 2 c: the faces round a vertex, in the same order: as many as vertices, on the border
/// one less.
std::vector<FaceHandle> one_ring_faces(const TriMesh& mesh, VertexHandle vertex);

/// Exercise 2 d: whether the surface ends at a vertex. A vertex without faces is not on a border.
bool is_on_border(const TriMesh& mesh, VertexHandle vertex);

}  // namespace lab
