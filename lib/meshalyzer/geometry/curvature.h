#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The area that a vertex has in the computation of its curvature.
enum class VertexArea : std::uint8_t {
  /// The part of each face that is closest to the vertex; half or a quarter of an obtuse face, so
  /// that the areas of all vertices sum up to the area of the surface (Meyer, Desbrun, Schröder and
  /// Barr 2003, "Discrete differential-geometry operators for triangulated 2-manifolds", figure 4).
  Mixed,
  /// The circumcentric dual cell by the cotangent formula (Meyer et al., equation 7); it may be
  /// negative at obtuse faces, and the curvature is then undefined.
  Voronoi,
  /// A third of each face.
  Barycentric,
  /// The whole of each face, which is three times the barycentric area.
  OneRing,
};

/// Returns "mixed", "voronoi", "barycentric" or "one-ring".
[[nodiscard]] std::string_view area_name(VertexArea area);
/// Returns the area with the given name, or nothing when no area has it.
[[nodiscard]] std::optional<VertexArea> vertex_area(std::string_view name);

/// The state of the curvature at a vertex: defined, or the reason why not.
enum class CurvatureState : std::uint8_t {
  /// The vertex has a curvature.
  Defined,
  /// No face uses the vertex.
  Unused,
  /// The vertex is on a border: the angle defect is the geodesic curvature of the border, not a
  /// curvature of the surface.
  Border,
  /// The faces are not one consistently oriented fan: a non-manifold or pinched vertex, or the end
  /// of a flipped edge. There is no surface, or it has no side that would define the sign.
  NotOneFan,
  /// The area is zero, negative or not finite, or so small or large that a figure is not finite; or
  /// the faces lie back to back, so that their normals cancel and no side defines the sign.
  NoArea,
};

inline constexpr std::size_t kCurvatureStates = 5;

/// The curvature at the vertices of a file, as columns of length #file vertices. Values are NaN
/// (directions zero) where the state is not Defined.
///
/// Curvatures are positive where the surface bends away from its normals, as a sphere with outward
/// normals does: k1 = k2 = 1 / r.
struct Curvature {
  std::vector<CurvatureState> state;
  /// The angle defect in radians at every vertex: 2 pi - pi #edges + pi #faces - the sum of the
  /// faces' angles, which is 2 pi - sum inside a surface and pi - sum on its border. Its sum over
  /// the vertices that faces use is 2 pi (V - E + F) for any complex (Gauss-Bonnet).
  std::vector<double> angle_defect;
  /// The area of each vertex that a face uses, in the mesh's unit squared. Faces of zero area
  /// contribute neither to it nor to the columns below.
  std::vector<double> area;
  /// The Gaussian curvature K = angle defect / area.
  std::vector<double> gaussian;
  /// The mean curvature H: half the length of the cotangent vector over the area, with the sign of
  /// its direction against the angle-weighted vertex normal (Meyer et al., equation 8); positive
  /// when perpendicular to it.
  std::vector<double> mean;
  /// The principal curvatures, k1 >= k2, estimated from how the normals of fitted quadrics turn
  /// along the edges (after Rusinkiewicz 2004, "Estimating curvatures and their derivatives on
  /// triangle meshes"); The estimate is independent of K and H and of the chosen area, so k1 k2 is
  /// not exactly K. Unlike K and H it converges on irregular meshes: see doc/benchmarks.md.
  std::vector<double> k1;
  std::vector<double> k2;
  /// The directions of k1 and k2, perpendicular unit tangents of arbitrary sign. They are zero
  /// where k1 and k2 are equal to rounding.
  std::vector<Vec3> direction1;
  std::vector<Vec3> direction2;
};

/// Measures the curvature at all vertices.
///
/// Sums have a fixed order, so the result is the same for any number of threads.
///
/// @complexity O(#V + #F).
[[nodiscard]] Curvature measure_curvature(const CutMesh& cut, VertexArea area = VertexArea::Mixed);

}  // namespace meshalyzer
