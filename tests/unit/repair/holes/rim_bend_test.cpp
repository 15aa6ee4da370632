#include "meshalyzer/repair/holes/internal/rim_bend.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/geometry/face_measures.h"
#include "support/curved_shapes.h"
#include "support/punched_holes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace meshalyzer {
namespace {

/// Returns a triangle on each edge of a loop, as long inwards as the edge, turned from the plane of
/// the face beyond by an angle in radians.
Patch turned_from_rim(const PreparedMesh& mesh, const HoleLoop& loop, double angle) {
  const CutMesh& cut = mesh.cut();
  const Soup& soup = mesh.soup();
  Patch patch;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3& from = soup.positions[loop.vertices[i]];
    const Vec3& to = soup.positions[loop.next(i)];
    const FaceHandle beyond = cut.mesh.face_handle(loop.halfedges[i]);
    const Vec3 normal = normal_of(face_corners(cut.mesh, beyond)).normalized();
    const Vec3 inward = normal.cross(to - from);
    const double length = (to - from).norm();
    patch.added.push_back(0.5 * (from + to) + std::cos(angle) * inward -
                          std::sin(angle) * length * normal);
    patch.triangles.push_back({loop.vertices[i], loop.next(i),
                               static_cast<Index>(soup.n_vertices() + patch.added.size() - 1)});
  }
  return patch;
}

/// A cylinder of radius 1 with a hole in its wall.
Soup punched_cylinder() {
  const Soup cylinder =
      shapes::curved_shape(shapes::Surface::Cylinder, shapes::Meshing::Regular, 3).soup;
  Index nearest = 0;
  for (Index v = 0; v < cylinder.n_vertices(); ++v) {
    const Vec3 wanted(1.0, 0.0, 0.0);
    if ((cylinder.positions[v] - wanted).norm() < (cylinder.positions[nearest] - wanted).norm()) {
      nearest = v;
    }
  }
  return test::punch(cylinder, nearest, 0.5).open;
}

/// Returns the loop that does not go round the cylinder's ends.
HoleLoop loop_in_wall(const PreparedMesh& mesh) {
  for (const HoleLoop& loop : find_hole_loops(mesh).loops) {
    if (distance_from(mesh.soup(), loop, Vec3(1.0, 0.0, 0.5)) < 0.2) return loop;
  }
  return {};
}

TEST(BendsIntoHole, TangentPatchOfACurvedSurfaceIsNotFlat) {
  const Soup soup = punched_cylinder();
  const PreparedMesh mesh(soup);
  const HoleLoop loop = loop_in_wall(mesh);
  ASSERT_GT(loop.size(), 8U);
  EXPECT_TRUE(bends_into_hole(mesh, loop, turned_from_rim(mesh, loop, 0.0)));
}

TEST(BendsIntoHole, PatchAtARightAngleToTheSurfaceIsNotExplainedByItsCurvature) {
  const Soup soup = punched_cylinder();
  const PreparedMesh mesh(soup);
  const HoleLoop loop = loop_in_wall(mesh);
  // The surface turns by at most 0.5 on its way to the middle, less than a third of pi / 2.
  EXPECT_FALSE(bends_into_hole(mesh, loop, turned_from_rim(mesh, loop, 0.5 * std::numbers::pi)));
}

TEST(TotalRimBend, IsTheLengthOfTheRimTimesTheAngle) {
  const Soup soup = punched_cylinder();
  const PreparedMesh mesh(soup);
  const HoleLoop loop = loop_in_wall(mesh);
  const Patch patch = turned_from_rim(mesh, loop, 0.25);
  EXPECT_NEAR(total_rim_bend(mesh, loop, patch), 0.25 * length_of(soup, loop), 1e-9);
  EXPECT_NEAR(mean_rim_bend(mesh, loop, patch), 0.25, 1e-9);
}

}  // namespace
}  // namespace meshalyzer
