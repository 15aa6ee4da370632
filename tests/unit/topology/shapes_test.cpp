#include "support/shapes.h"

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/topology/boundary.h"
#include "meshalyzer/topology/edges.h"
#include "support/constants.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace meshalyzer {
namespace {

using Counts = std::array<std::size_t, 4>;

/// Vertices, edges, faces and boundaries, as the library counts them.
Counts counts_of(const Soup& soup) {
  const CutMesh cut = build(soup);
  return {soup.n_vertices(), n_edges(cut), soup.n_faces(), find_boundary_loops(cut).size()};
}

bool is_consistent(const Soup& soup) {
  const CutMesh cut = build(soup);
  return cut.side.flipped_edges.size() == 0 && cut.side.non_manifold_edges.size() == 0;
}

double area_of(const Soup& soup) {
  double twice = 0.0;
  for (const auto& [a, b, c] : soup.triangles) {
    const Vec3& p = soup.positions[a];
    twice += (soup.positions[b] - p).cross(soup.positions[c] - p).norm();
  }
  return twice / 2;
}

double volume_of(const Soup& soup) {
  double six_fold = 0.0;
  for (const auto& [a, b, c] : soup.triangles) {
    six_fold += soup.positions[a].dot(soup.positions[b].cross(soup.positions[c]));
  }
  return six_fold / 6;
}

TEST(Shapes, HaveTheCountsTheyClaim) {
  EXPECT_EQ(counts_of(shapes::tetrahedron()), (Counts{4, 6, 4, 0}));
  EXPECT_EQ(counts_of(shapes::cube()), (Counts{8, 18, 12, 0}));
  EXPECT_EQ(counts_of(shapes::open_cube()), (Counts{8, 17, 10, 1}));
  EXPECT_EQ(counts_of(shapes::uv_sphere(4, 5)), (Counts{17, 45, 30, 0}));
  EXPECT_EQ(counts_of(shapes::uv_sphere(2, 3)), (Counts{5, 9, 6, 0}));
  EXPECT_EQ(counts_of(shapes::icosphere(0)), (Counts{12, 30, 20, 0}));
  EXPECT_EQ(counts_of(shapes::icosphere(2)), (Counts{162, 480, 320, 0}));
  EXPECT_EQ(counts_of(shapes::torus(3, 1, 5, 4)), (Counts{20, 60, 40, 0}));
  EXPECT_EQ(counts_of(shapes::genus_block(0)), (Counts{16, 42, 28, 0}));
  EXPECT_EQ(counts_of(shapes::genus_block(3)), (Counts{64, 204, 136, 0}));
  EXPECT_EQ(counts_of(shapes::moebius_strip(3)), (Counts{6, 12, 6, 1}));
  EXPECT_EQ(counts_of(shapes::projective_plane()), (Counts{6, 15, 10, 0}));
  EXPECT_EQ(counts_of(shapes::klein_bottle(4, 4)), (Counts{16, 48, 32, 0}));
  EXPECT_EQ(counts_of(shapes::two_tetrahedra_sharing_vertex()), (Counts{7, 12, 8, 0}));
  EXPECT_EQ(counts_of(shapes::two_tetrahedra_sharing_edge()), (Counts{6, 11, 8, 0}));
  EXPECT_EQ(counts_of(shapes::two_tetrahedra_sharing_face()), (Counts{5, 9, 8, 0}));
  EXPECT_EQ(counts_of(shapes::nested_cubes(shapes::InnerShell::Cavity)), (Counts{16, 36, 24, 0}));
  EXPECT_EQ(counts_of(shapes::pillow()), (Counts{3, 3, 2, 0}));
  EXPECT_EQ(counts_of(shapes::fan_of_three()), (Counts{5, 7, 3, 3}));
  EXPECT_EQ(counts_of(shapes::grid(3, 2)), (Counts{12, 23, 12, 1}));
}

TEST(Shapes, TwoSidedOnesAreConsistent) {
  EXPECT_TRUE(is_consistent(shapes::tetrahedron()));
  EXPECT_TRUE(is_consistent(shapes::cube()));
  EXPECT_TRUE(is_consistent(shapes::open_cube()));
  EXPECT_TRUE(is_consistent(shapes::uv_sphere(4, 5)));
  EXPECT_TRUE(is_consistent(shapes::icosphere(2)));
  EXPECT_TRUE(is_consistent(shapes::torus(3, 1, 5, 4)));
  EXPECT_TRUE(is_consistent(shapes::genus_block(3)));
  EXPECT_TRUE(is_consistent(shapes::two_tetrahedra_sharing_vertex()));
  EXPECT_TRUE(is_consistent(shapes::nested_cubes(shapes::InnerShell::Cavity)));
  EXPECT_TRUE(is_consistent(shapes::pillow()));
  EXPECT_TRUE(is_consistent(shapes::grid(3, 2)));
}

TEST(Shapes, FlatOnesHaveTheAreaAndVolumeTheyClaim) {
  EXPECT_DOUBLE_EQ(area_of(shapes::tetrahedron()), (3 + std::sqrt(3.0)) / 2);
  EXPECT_DOUBLE_EQ(volume_of(shapes::tetrahedron()), 1.0 / 6);
  EXPECT_DOUBLE_EQ(area_of(shapes::cube(2.0, {1, -1, 5})), 24.0);
  EXPECT_DOUBLE_EQ(volume_of(shapes::cube(2.0, {1, -1, 5})), 8.0);
  EXPECT_DOUBLE_EQ(area_of(shapes::open_cube()), 5.0);
  EXPECT_DOUBLE_EQ(area_of(shapes::genus_block(0)), 14.0);
  EXPECT_DOUBLE_EQ(volume_of(shapes::genus_block(0)), 3.0);
  EXPECT_DOUBLE_EQ(area_of(shapes::genus_block(2)), 50.0);
  EXPECT_DOUBLE_EQ(volume_of(shapes::genus_block(2)), 13.0);
  EXPECT_DOUBLE_EQ(volume_of(shapes::two_tetrahedra_sharing_vertex()), 1.0 / 3);
  EXPECT_DOUBLE_EQ(volume_of(shapes::two_tetrahedra_sharing_edge()), 1.0 / 3);
  EXPECT_DOUBLE_EQ(volume_of(shapes::two_tetrahedra_sharing_face()), 1.0 / 3);
  EXPECT_DOUBLE_EQ(area_of(shapes::nested_cubes(shapes::InnerShell::Outward)), 60.0);
  EXPECT_DOUBLE_EQ(volume_of(shapes::nested_cubes(shapes::InnerShell::Outward)), 28.0);
  EXPECT_DOUBLE_EQ(volume_of(shapes::nested_cubes(shapes::InnerShell::Cavity)), 26.0);
  EXPECT_DOUBLE_EQ(area_of(shapes::pillow()), 1.0);
  EXPECT_DOUBLE_EQ(area_of(shapes::grid(3, 2)), 6.0);
  EXPECT_DOUBLE_EQ(volume_of(shapes::flipped(shapes::cube())), -1.0);
}

TEST(Shapes, RoundOnesHaveTheAreaAndVolumeTheyClaim) {
  const double edge = 1 / std::sin(2 * kPi / 5);
  EXPECT_NEAR(area_of(shapes::icosphere(0)), 5 * std::sqrt(3.0) * edge * edge, 1e-12);
  EXPECT_NEAR(volume_of(shapes::icosphere(0)), 5 * (3 + std::sqrt(5.0)) * std::pow(edge, 3) / 12,
              1e-12);
  // An octahedron: eight equilateral triangles of side sqrt 2; two pyramids of height 1 on a
  // square.
  EXPECT_NEAR(area_of(shapes::uv_sphere(2, 4)), 4 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(volume_of(shapes::uv_sphere(2, 4)), 4.0 / 3, 1e-12);
  // nu nv R r^2 sin(2 pi / nu) sin(2 pi / nv) / 2 = 4 * 4 * 3 * 1 * 1 * 1 / 2.
  EXPECT_NEAR(volume_of(shapes::torus(3, 1, 4, 4)), 24.0, 1e-12);
}

TEST(Shapes, BandsOfASphereAddUpToItsFormulas) {
  const std::size_t n_lat = 6;
  const std::size_t n_lon = 7;
  const double a = kPi / n_lon;
  double area = 0.0;
  double volume = 0.0;
  for (std::size_t i = 1; i <= n_lat; ++i) {
    const double upper = kPi * static_cast<double>(i - 1) / n_lat;
    const double lower = kPi * static_cast<double>(i) / n_lat;
    const double r0 = std::sin(upper);
    const double r1 = std::sin(lower);
    const double dz = std::cos(upper) - std::cos(lower);
    area += n_lon * std::sin(a) * (r0 + r1) * std::hypot(dz, std::cos(a) * (r1 - r0));
    volume += n_lon * std::sin(2 * a) / 6 * dz * (r0 * r0 + r0 * r1 + r1 * r1);
  }
  EXPECT_NEAR(area_of(shapes::uv_sphere(n_lat, n_lon)), area, 1e-12);
  EXPECT_NEAR(volume_of(shapes::uv_sphere(n_lat, n_lon)), volume, 1e-12);
}

TEST(Shapes, BandsOfATorusAddUpToItsFormulas) {
  const std::size_t nu = 9;
  const std::size_t nv = 5;
  const double a = kPi / nu;
  double area = 0.0;
  for (std::size_t j = 1; j <= nv; ++j) {
    const double before = 2 * kPi * static_cast<double>(j - 1) / nv;
    const double after = 2 * kPi * static_cast<double>(j) / nv;
    const double rho0 = 3 + std::cos(before);
    const double rho1 = 3 + std::cos(after);
    const double dz = std::sin(after) - std::sin(before);
    area += nu * std::sin(a) * (rho0 + rho1) * std::hypot(dz, std::cos(a) * (rho1 - rho0));
  }
  const Soup torus = shapes::torus(3, 1, nu, nv);
  EXPECT_NEAR(area_of(torus), area, 1e-12);
  EXPECT_NEAR(volume_of(torus), 0.5 * nu * nv * 3 * std::sin(2 * kPi / nu) * std::sin(2 * kPi / nv),
              1e-12);
}

}  // namespace
}  // namespace meshalyzer
