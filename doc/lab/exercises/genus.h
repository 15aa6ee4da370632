#pragma once

#include <meshalyzer/mesh/tri_mesh.h>
#include <optional>

/// Exercise 6: Euler-Poincaré and genus. See 6_euler_poincare_and_genus.md.
namespace lab {

using meshalyzer::TriMesh;

/// Exercise 6 a: equation (8): the genus of one closed shell of V vertices, E edges and F faces;
/// nothing where the formula gives no whole number >= 0.
std::optional<int> genus_of_closed_shell(int n_vertices, int n_edges, int n_faces);

/// Exercise 6 b: V - E + F, where V counts only the vertices that faces use.
int euler_number(const TriMesh& mesh);

/// Exercise 6 c: the loops of half-edges that have no face.
int n_boundaries(const TriMesh& mesh);

/// Exercise 6 d: the pieces that the faces fall into. Two faces hang together where they share a
/// vertex (the mesh has no pinched vertices, so it would be the same with edges).
int n_components(const TriMesh& mesh);

/// Exercise 6 e: the genus of all components together, which may have boundaries.
int genus(const TriMesh& mesh);

}  // namespace lab
