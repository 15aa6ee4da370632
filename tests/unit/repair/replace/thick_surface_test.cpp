#include "meshalyzer/repair/replace/internal/thick_surface.h"

#include "meshalyzer/prepared/prepared_mesh.h"
#include "support/shapes.h"
#include "support/surface_distance.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <numeric>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

/// All faces of a mesh, made thick; parts of the surface may cross.
Soup thick_with_crossings(const Soup& soup, double thickness,
                          std::span<const Index> separable = {}) {
  std::vector<Index> faces(soup.n_faces());
  std::iota(faces.begin(), faces.end(), Index{0});
  const NewSurface made = thicken(soup, faces, thickness, separable);
  EXPECT_EQ(made.origins.size(), made.triangles.size());
  return shapes::make(made.positions, made.triangles);
}

/// All faces of a mesh, made thick; the surface must be closed, manifold, oriented and embedded.
Soup thick(const Soup& soup, double thickness) {
  Soup result = thick_with_crossings(soup, thickness);
  const PreparedMesh mesh(result);
  for (const auto h : mesh.cut().mesh.halfedges()) {
    EXPECT_FALSE(mesh.cut().mesh.is_boundary(h));
    if (mesh.cut().mesh.is_boundary(h)) break;
  }
  EXPECT_TRUE(mesh.cut().side.non_manifold_vertices.empty());
  EXPECT_TRUE(mesh.intersecting_pairs().empty());
  return result;
}

TEST(Thicken, OneFaceBecomesAPrism) {
  // A triangle of area 1/2.
  const Soup face = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const Soup prism = thick(face, 0.25);
  EXPECT_EQ(prism.n_vertices(), 6U);
  EXPECT_EQ(prism.n_faces(), 8U);
  EXPECT_NEAR(volume_of(prism), 0.125, 1e-12);
}

TEST(Thicken, GridBecomesAPlate) {
  const Soup grid = shapes::grid(4, 3);
  const double area = [&] {
    double sum = 0;
    for (Index f = 0; f < grid.n_faces(); ++f) {
      const auto [a, b, c] = corners_of(grid, f);
      sum += (b - a).cross(c - a).norm() / 2;
    }
    return sum;
  }();
  EXPECT_NEAR(volume_of(thick(grid, 0.01)), 0.01 * area, 1e-9);
}

TEST(Thicken, MoebiusStripGetsOneRimAndAnInside) {
  EXPECT_GT(volume_of(thick(shapes::moebius_strip(24), 0.01)), 0);
}

TEST(Thicken, FacesRoundAnEdgeAreJoinedToTheirNeighbours) {
  EXPECT_GT(volume_of(thick(shapes::fan_of_three(), 0.01)), 0);
}

TEST(Thicken, FlippedFaceMakesNoDifference) {
  const Soup grid = shapes::grid(3, 3);
  EXPECT_NEAR(volume_of(thick(shapes::flipped(grid, std::vector<Index>{2, 5}), 0.01)),
              volume_of(thick(grid, 0.01)), 1e-12);
}

TEST(Thicken, SeparableFaceFoldedSharplyBackLiesInItsSolid) {
  // At vertex 0 two faces of a plane outweigh the third, which is folded back over them by 135
  // degrees: what is in front of all three on average is behind that one.
  const Soup folded =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {-0.5, 1, 0}, {0.5, 0.7, 0.7}},
                   {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}});
  const Soup solid = thick_with_crossings(folded, 0.01, std::vector<Index>{2});
  for (Index f = 0; f < folded.n_faces(); ++f) {
    const auto corners = corners_of(folded, f);
    const Vec3 centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
    for (const Vec3& corner : corners) {
      const Vec3 near_corner = 0.98 * corner + 0.02 * centroid;
      EXPECT_GT(test::summed_winding(solid, near_corner), 0.5) << f << " at " << corner.transpose();
    }
  }
}

}  // namespace
}  // namespace meshalyzer
