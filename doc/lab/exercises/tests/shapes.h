#pragma once

#include <array>
#include <meshalyzer/mesh/tri_mesh.h>
#include <vector>

/// Meshes of which every figure is known, made in code.
namespace lab::shapes {

using meshalyzer::TriMesh;
using meshalyzer::Vec3;
using Faces = std::vector<std::array<int, 3>>;

/// Vertices 0, e1, e2, e3: three right-angled faces and an equilateral one.
Faces tetrahedron_faces();
TriMesh tetrahedron();

/// Side 2 about the origin. Each face of the cube is cut along a diagonal, so that its corners have
/// 3 to 6 triangles.
TriMesh cube();

/// The vertices +-e1, +-e2, +-e3; all faces are equilateral with sides of length sqrt(2).
Faces octahedron_faces();
TriMesh octahedron();
/// The same without the face of +e1, +e2 and +e3.
TriMesh open_octahedron();

/// A sphere of radius 1, two poles and `n - 1` rings of `n` vertices, which all lie on it.
TriMesh sphere(int n);

/// Radii 2 and 1: n times n vertices.
TriMesh torus(int n);

/// A square of side 2 at z = 0, normals up, four faces round vertex 0 in the middle.
TriMesh square();

/// Vertex 0 in the middle of six vertices, by turns at distance 0.1 and 1: its faces have obtuse
/// angles at the near ones.
TriMesh star();

/// A ring of 2 n triangles in the plane z = 0, normals up: two boundaries.
TriMesh annulus(int n);

/// A pyramid of four faces with its apex, vertex 0, at height z above the corners of a square
/// (+-1, 0, 0), (0, +-1, 0), and closed below by one more vertex at z = -1.
TriMesh double_pyramid(double z);

/// All faces turned round.
TriMesh turned_inside_out(const TriMesh& mesh);

TriMesh moved(TriMesh mesh, const Vec3& by);

/// Both in one mesh.
TriMesh together(TriMesh mesh, const TriMesh& other);

/// With one more vertex that no face uses.
TriMesh with_orphan(TriMesh mesh);

}  // namespace lab::shapes
