#pragma once

#include "meshalyzer/mesh/side_table.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The area that a curvature is spread over at a vertex.
enum class VertexArea : std::uint8_t {
  /// The part of each face that is closest to the vertex; where a face is obtuse, half or a quarter
  /// of it, so that the areas of all vertices are the area of the surface (Meyer, Desbrun, Schröder
  /// and Barr 2003, "Discrete differential-geometry operators for triangulated 2-manifolds", figure
  /// 4).
  Mixed,
  /// The circumcentric dual cell by the cotangent formula (Meyer et al., equation 7); may be
  /// negative at obtuse faces, and then there is no curvature.
  Voronoi,
  /// A third of each face.
  Barycentric,
  /// The whole of each face, as in the laboratory report: three times the barycentric one.
  OneRing,
};

/// "mixed", "voronoi", "barycentric", "one-ring".
[[nodiscard]] std::string_view area_name(VertexArea area);
/// Returns the area of a name; nothing where there is none of that name.
[[nodiscard]] std::optional<VertexArea> vertex_area(std::string_view name);

/// Tells whether a surface has a curvature at a vertex.
enum class CurvatureState : std::uint8_t {
  /// The vertex has a curvature.
  Defined,
  /// No face uses the vertex.
  Unused,
  /// The surface ends here: the angle defect is the turning of the border (geodesic curvature), not
  /// a curvature of the surface.
  Border,
  /// The faces are not one consistently oriented fan: a non-manifold or pinched vertex, or the end
  /// of a flipped edge. There is no surface, or it has no side for the sign.
  NotOneFan,
  /// The area is zero, negative or not finite, or so small or large that a figure is not finite; or
  /// the faces lie back to back, so that their normals cancel and there is no side for the sign.
  NoArea,
};

inline constexpr std::size_t kCurvatureStates = 5;

/// The curvature at the vertices of a file, as columns of #file vertices; NaN (zero for directions)
/// where the state is not Defined.
///
/// Signs: positive where the surface bends away from the side that its normals point to, as a
/// sphere with outward normals does: k1 = k2 = 1 / r.
struct Curvature {
  std::vector<CurvatureState> state;
  /// Radians, at every vertex: 2 pi - pi #edges + pi #faces - the sum of the faces' angles, which
  /// is 2 pi - sum inside a surface and pi - sum on its border. Summed over the vertices that faces
  /// use it is 2 pi (V - E + F) for any complex (Gauss-Bonnet).
  std::vector<double> angle_defect;
  /// The area of each vertex in the mesh's unit squared, where a face uses the vertex. Faces of
  /// zero area add nothing to it, nor to the columns below.
  std::vector<double> area;
  /// K = angle defect / area.
  std::vector<double> gaussian;
  /// H: half the length of the cotangent vector over the area, with the sign of its direction
  /// against the vertex normal by angle (Meyer et al., equation 8); positive at a right angle to
  /// it.
  std::vector<double> mean;
  /// The principal curvatures, k1 >= k2, by how the normals of fitted quadrics turn along the edges
  /// (after Rusinkiewicz 2004, "Estimating curvatures and their derivatives on triangle meshes");
  /// another estimate than K and H, so k1 k2 is not exactly K, and the area chosen has no part in
  /// it. Unlike K and H it converges on irregular meshes: see doc/benchmarks.md.
  std::vector<double> k1;
  std::vector<double> k2;
  /// Unit tangents at right angles to each other; of a pair of opposite ones either. Zero where k1
  /// and k2 are the same to rounding.
  std::vector<Vec3> direction1;
  std::vector<Vec3> direction2;
};

/// Measures the curvature at all vertices.
///
/// Sums run in a fixed order: the result is the same for any number of threads.
///
/// @complexity O(#V + #F).
[[nodiscard]] Curvature measure_curvature(const CutMesh& cut, VertexArea area = VertexArea::Mixed);

}  // namespace meshalyzer
