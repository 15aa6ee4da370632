#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Meshes built in code, with true figures. V, E, F, B: vertices, edges, faces, boundaries.
///
/// Ids are implicit (1, 2, ...), lengths without a unit, and closed orientable shapes outward
/// unless said otherwise.
namespace meshalyzer::shapes {

/// Returns a soup of these records and nothing else.
[[nodiscard]] Soup make(std::vector<Vec3> positions, std::vector<Triangle> triangles);

/// The corner of the unit cube at the origin: (0,0,0), (1,0,0), (0,1,0), (0,0,1).
/// Area (3 + sqrt 3) / 2, volume 1/6, genus 0; V 4, E 6, F 4.
[[nodiscard]] Soup tetrahedron();

/// The cube [corner, corner + side]^3, each square split along a diagonal.
/// Area 6 side^2, volume side^3, genus 0; V 8, E 18, F 12.
[[nodiscard]] Soup cube(double side = 1.0, const Vec3& corner = Vec3::Zero());

/// The box between two opposite corners, its faces split like those of the cube.
[[nodiscard]] Soup box(const Vec3& low, const Vec3& high);

/// The unit cube without the two faces of its top (z = 1): area 5; V 8, E 17, F 10, B 1.
[[nodiscard]] Soup open_cube();

/// Inscribed in the unit sphere: n_lat >= 2 bands of n_lon >= 3 facets, poles on the z axis.
/// V (n_lat - 1) n_lon + 2, F 2 (n_lat - 1) n_lon, genus 0. With r_i = sin(pi i / n_lat),
/// z_i = cos(pi i / n_lat), a = pi / n_lon, and sums over the bands i = 1 ... n_lat:
/// area   n_lon sin a sum (r_i + r_(i-1)) sqrt((z_i - z_(i-1))^2 + cos(a)^2 (r_i - r_(i-1))^2),
/// volume n_lon sin(2a) / 6 sum |z_i - z_(i-1)| (r_i^2 + r_i r_(i-1) + r_(i-1)^2).
[[nodiscard]] Soup uv_sphere(std::size_t n_lat, std::size_t n_lon);

/// The regular icosahedron in the unit sphere, each face split in four `level` times and pushed out
/// to the sphere. V 10 4^level + 2, E 30 4^level, F 20 4^level, genus 0.
/// Level 0, with edge a = 1 / sin(2 pi / 5): area 5 sqrt(3) a^2, volume 5 (3 + sqrt 5) a^3 / 12.
/// Area grows to 4 pi, volume to 4 pi / 3.
[[nodiscard]] Soup icosphere(std::size_t level);

/// A torus round the z axis: nu >= 3 steps round the axis at distance R, nv >= 3 round the tube of
/// radius r. Genus 1; V nu nv, E 3 nu nv, F 2 nu nv.
/// Volume nu nv R r^2 sin(2 pi / nu) sin(2 pi / nv) / 2. Area, with rho_j = R + r cos(2 pi j / nv),
/// z_j = r sin(2 pi j / nv), a = pi / nu and the sum over j = 1 ... nv:
/// nu sin a sum (rho_j + rho_(j-1)) sqrt((z_j - z_(j-1))^2 + cos(a)^2 (rho_j - rho_(j-1))^2).
[[nodiscard]] Soup torus(double R, double r, std::size_t nu, std::size_t nv);

/// A slab of (2n + 1) x 3 x 1 unit cubes with n of them taken out of its middle row: n square
/// holes. Genus n, area 18 n + 14, volume 5 n + 3; V 16 n + 16, E 54 n + 42, F 36 n + 28.
[[nodiscard]] Soup genus_block(std::size_t n);

/// A strip of n >= 3 quads with half a twist. Not orientable; V 2n, E 4n, F 2n, B 1.
[[nodiscard]] Soup moebius_strip(std::size_t n);

/// The projective plane on six vertices: every two of them are joined. Closed, not orientable, its
/// faces cross each other in space; V 6, E 15, F 10.
[[nodiscard]] Soup projective_plane();

/// A Klein bottle of nu x nv quads (both >= 4). Closed, not orientable; V nu nv, E 3 nu nv,
/// F 2 nu nv.
[[nodiscard]] Soup klein_bottle(std::size_t nu, std::size_t nv);

/// Two tetrahedra, each outward, that have one vertex by id in common (the origin), which is
/// pinched. Volume 1/3; V 7, E 12, F 8.
[[nodiscard]] Soup two_tetrahedra_sharing_vertex();

/// Two tetrahedra, each outward, that have one edge by id in common, with four faces. Its ends are
/// vertices 0 and 3. Volume 1/3; V 6, E 11, F 8.
[[nodiscard]] Soup two_tetrahedra_sharing_edge();

/// Two tetrahedra, each outward, that have three vertices by id in common, and the face on them
/// twice. Three edges with four faces each. V 5, E 9, F 8.
[[nodiscard]] Soup two_tetrahedra_sharing_face();

/// The orientation of the inner one of two nested shells.
enum class InnerShell : std::uint8_t {
  /// The inner shell points outward, as if the outer one did not exist.
  Outward,
  /// The inner shell points inward: it is the wall of a cavity.
  Cavity,
};

/// The cube [0, 3]^3 and, as the faces 12 ... 23, the cube [1, 2]^3. Area 60;
/// volume 28 with an outward inner shell, 26 with a cavity. V 16, E 36, F 24.
[[nodiscard]] Soup nested_cubes(InnerShell inner);

/// Two faces back to back on the same three vertices: closed, manifold, consistent. Area 1 (1/2
/// each), volume 0, genus 0; V 3, E 3, F 2.
[[nodiscard]] Soup pillow();

/// Three faces on the edge of vertices 0 and 1. Three chains of two border edges; V 5, E 7, F 3,
/// B 3.
[[nodiscard]] Soup fan_of_three();

/// The rectangle [0, nx] x [0, ny] in the plane z = 0, facing up, of 2 nx ny half squares.
/// Area nx ny; V (nx + 1)(ny + 1), E 3 nx ny + nx + ny, F 2 nx ny, B 1.
[[nodiscard]] Soup grid(std::size_t nx, std::size_t ny);

/// n triangles without common vertices, whose corners are random points of the unit cube: about
/// 0.28 of all pairs of them intersect, and nearly all of these cross. The same on every platform.
[[nodiscard]] Soup tangle(std::size_t n);

/// Joins both meshes in one file, b's records after a's. No vertex is shared.
[[nodiscard]] Soup merged(Soup a, const Soup& b);

[[nodiscard]] Soup translated(Soup soup, const Vec3& by);

/// Scales a mesh about the origin.
[[nodiscard]] Soup scaled(Soup soup, double factor);

/// Turns every face over.
[[nodiscard]] Soup flipped(Soup soup);

/// Turns only these faces over.
[[nodiscard]] Soup flipped(Soup soup, std::span<const Index> faces);

/// Removes these faces; all vertices stay.
[[nodiscard]] Soup without_faces(Soup soup, std::span<const Index> faces);

/// Returns the same faces in another order, each beginning with another corner. The same seed gives
/// the same order on every platform.
[[nodiscard]] Soup shuffled_faces(Soup soup, std::uint32_t seed);

/// Returns the permutation that renumbered_vertices() uses: the new index of each old one.
[[nodiscard]] std::vector<Index> permutation(std::size_t n, std::uint32_t seed);

/// Returns the same mesh with its vertices in another order.
[[nodiscard]] Soup renumbered_vertices(Soup soup, std::uint32_t seed);

}  // namespace meshalyzer::shapes
