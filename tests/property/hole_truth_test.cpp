#include "support/curved_shapes.h"
#include "support/effort.h"
#include "support/punched_holes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace meshalyzer {
namespace {

constexpr std::size_t kLevel = 3;
constexpr double kRadius = 0.4;

/// The vertex that is nearest to a point which is on each of the surfaces, or near, and far from
/// the borders of all.
Index vertex_to_punch(const Soup& soup, shapes::Surface surface) {
  Vec3 wanted(1.0, 0.0, 0.0);
  if (surface == shapes::Surface::Torus) wanted = Vec3(3.0, 0.0, 0.0);
  if (surface == shapes::Surface::Ellipsoid) wanted = Vec3(1.5, 0.0, 0.0);
  if (surface == shapes::Surface::MonkeySaddle) wanted = Vec3(0.2, 0.1, 0.0);
  Index nearest = 0;
  for (Index v = 1; v < soup.n_vertices(); ++v) {
    if ((soup.positions[v] - wanted).norm() < (soup.positions[nearest] - wanted).norm())
      nearest = v;
  }
  return nearest;
}

TEST(FillHoles, IsNearerToWhatWasThereThanThePatchOfLeastArea) {
  double chosen_sum = 0.0;
  double least_area_sum = 0.0;
  test::Effort share;
  for (const shapes::Surface surface : shapes::kSurfaces) {
    for (const shapes::Meshing meshing : shapes::kMeshings) {
      if (!share.runs_next()) continue;
      SCOPED_TRACE(std::string(shapes::surface_name(surface)) + ", " +
                   std::string(shapes::meshing_name(meshing)));
      const Soup soup = shapes::curved_shape(surface, meshing, kLevel).soup;
      const test::PunchedMesh punched = test::punch(soup, vertex_to_punch(soup, surface), kRadius);
      const test::FillError chosen = test::fill_error(punched, test::Filling::Auto);
      const test::FillError least_area = test::fill_error(punched, test::Filling::LeastArea);
      ASSERT_TRUE(std::isfinite(chosen.mean));
      EXPECT_LT(chosen.mean, least_area.mean);
      EXPECT_LT(chosen.largest, least_area.largest);
      chosen_sum += chosen.mean;
      least_area_sum += least_area.mean;
    }
  }
  EXPECT_LT(chosen_sum, least_area_sum / 3.0);
}

}  // namespace
}  // namespace meshalyzer
