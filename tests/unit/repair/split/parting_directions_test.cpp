#include "meshalyzer/repair/split/internal/parting_directions.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace meshalyzer {
namespace {

/// The faces round the tip of a blade that slopes upwards from the origin: its two sides are nearly
/// parallel, and one of them is bent along lines at irregular distances.
std::vector<Corners> tip_of_blade(double thickness) {
  constexpr double kSlope = 0.3;
  const std::array<std::array<double, 2>, 6> section{
      {{-0.9, 0}, {-0.5, 1}, {0.1, 1.3}, {0.2, 1.2}, {0.8, 0.3}, {0.85, -0.1}}};
  const auto corner = [&](std::size_t i) {
    const auto& [y, height] = section.at(i % section.size());
    return Vec3(1, y, kSlope + height * thickness);
  };
  std::vector<Corners> faces;
  for (std::size_t i = 0; i < section.size(); ++i) {
    faces.push_back({Vec3::Zero(), corner(i), corner(i + 1)});
  }
  return faces;
}

/// Returns how far the end of a vector of length 1 along a direction is behind the plane of a face.
double depth(const Vec3& direction, const Corners& face) {
  const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
  return -direction.normalized().dot(normal);
}

TEST(PartingDirections, FirstLeadsBehindAllFacesOfABladeHoweverThin) {
  for (const double thickness : {0.1, 1e-2, 1e-3, 1e-4}) {
    const std::vector<Corners> faces = tip_of_blade(thickness);
    const std::vector<Vec3> directions = parting_directions(faces);
    ASSERT_FALSE(directions.empty());
    for (const Corners& face : faces) EXPECT_GT(depth(directions[0], face), 0.0) << thickness;
  }
}

}  // namespace
}  // namespace meshalyzer
