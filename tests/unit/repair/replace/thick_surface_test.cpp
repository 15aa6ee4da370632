#include "meshalyzer/repair/replace/internal/thick_surface.h"

#include "meshalyzer/prepared/prepared_mesh.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace meshalyzer {
namespace {

/// All faces of a mesh, made thick; the surface must be closed, manifold, oriented and embedded.
Soup thick(const Soup& soup, double thickness) {
  std::vector<Index> faces(soup.n_faces());
  std::iota(faces.begin(), faces.end(), Index{0});
  const NewSurface made = thicken(soup, faces, thickness);
  EXPECT_EQ(made.origins.size(), made.triangles.size());
  Soup result = shapes::make(made.positions, made.triangles);
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

}  // namespace
}  // namespace meshalyzer
