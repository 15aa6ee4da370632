#pragma once

#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

/// Smooth surfaces of known curvature, as meshes.
namespace meshalyzer::shapes {

/// The zeros of a function, which is positive on the side that the normals point to.
enum class Surface : std::uint8_t {
  /// The unit sphere; an icosahedron split in four repeatedly. Closed.
  Sphere,
  /// The ellipsoid with semi-axes 1.5, 1, 0.75; a stretched sphere. Closed.
  Ellipsoid,
  /// The torus with radii 2 (of the axis) and 1 (of the tube). Closed, genus 1.
  Torus,
  /// The cylinder of radius 1 and height 2, open at both ends.
  Cylinder,
  /// x^2 + y^2 = cosh^2 z, |z| <= 1: a minimal surface, mean curvature 0. Open at both ends.
  Catenoid,
  /// z = x^3 / 3 - x y^2, |x|, |y| <= 1, normals up. One border.
  MonkeySaddle,
};

inline constexpr std::array<Surface, 6> kSurfaces{Surface::Sphere,   Surface::Ellipsoid,
                                                  Surface::Torus,    Surface::Cylinder,
                                                  Surface::Catenoid, Surface::MonkeySaddle};

/// The distribution of the vertices on the surface.
enum class Meshing : std::uint8_t {
  /// The vertices lie on a grid of the surface's parameters, with every square split the same way,
  /// or on an icosahedron's subdivision: nearly all valences are 6.
  Regular,
  /// The vertices are moved along the surface by up to 0.25 steps of the grid, and a third of the
  /// edges is flipped if no angle becomes less than 20 degrees: valences 3 to 10 or so.
  Irregular,
  /// The mesh is irregular, and its vertices are moved along the normal by up to 0.01 of the mean
  /// edge length.
  Noisy,
};

inline constexpr std::array<Meshing, 3> kMeshings{Meshing::Regular, Meshing::Irregular,
                                                  Meshing::Noisy};

[[nodiscard]] std::string_view surface_name(Surface surface);
[[nodiscard]] std::string_view meshing_name(Meshing meshing);

/// The true figures of the smooth surface at a vertex; for a noisy mesh, at its place before it was
/// moved. The signs are those of meshalyzer::Curvature.
struct TrueCurvature {
  double gaussian = 0.0;
  double mean = 0.0;
  double k1 = 0.0;
  double k2 = 0.0;
  /// Unit tangents; meaningless if k1 and k2 are equal.
  Vec3 direction1 = Vec3::Zero();
  Vec3 direction2 = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

struct CurvedShape {
  Soup soup;
  /// One entry for each vertex.
  std::vector<TrueCurvature> truth;
};

/// A mesh of a surface.
///
/// @param level  0, 1, ...: every level has half the edge length of the one before. Level 3 has 642
/// vertices on the sphere and 1,089 to 4,608 on the others.
/// @param seed  The seed of random choices; the same seed gives the same mesh.
[[nodiscard]] CurvedShape curved_shape(Surface surface, Meshing meshing, std::size_t level,
                                       std::uint32_t seed = 1);

/// Returns the curvature of a surface at a point of it.
[[nodiscard]] TrueCurvature true_curvature(Surface surface, const Vec3& point);

}  // namespace meshalyzer::shapes
