#include "meshalyzer/geometry/curvature.h"
#include "meshalyzer/mesh/build.h"
#include "support/constants.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <span>
#include <string>

namespace meshalyzer {
namespace {

/// Over the vertices that faces use, in units of 2 pi.
double total_defect(const Curvature& curvature) {
  double sum = 0.0;
  for (std::size_t v = 0; v < curvature.state.size(); ++v) {
    if (curvature.state[v] != CurvatureState::Unused) sum += curvature.angle_defect[v];
  }
  return sum / (2 * kPi);
}

/// V - E + F of the faces of the complex.
double euler_number(const Soup& soup) {
  std::set<Index> vertices;
  std::set<std::array<Index, 2>> edges;
  int faces = 0;
  for (const Triangle& t : soup.triangles) {
    if (!is_in_complex(t)) continue;
    ++faces;
    vertices.insert(t.begin(), t.end());
    for (std::size_t i = 0; i < 3; ++i) {
      edges.insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    }
  }
  return static_cast<double>(vertices.size()) - static_cast<double>(edges.size()) + faces;
}

struct Case {
  const char* name;
  Soup soup;
  double euler;
};

void expect_gauss_bonnet(std::span<const Case> cases) {
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    ASSERT_EQ(euler_number(c.soup), c.euler);
    EXPECT_NEAR(total_defect(measure_curvature(build(c.soup))), c.euler, 1e-12);
  }
}

TEST(GaussBonnet, HoldsOnClosedSurfacesOfAnyGenus) {
  expect_gauss_bonnet(std::array{
      Case{"sphere", shapes::icosphere(3), 2}, Case{"torus", shapes::torus(2, 0.7, 24, 15), 0},
      Case{"two holes", shapes::genus_block(2), -2},
      Case{"nine holes", shapes::genus_block(9), -16},
      Case{"two spheres", shapes::nested_cubes(shapes::InnerShell::Cavity), 4},
      Case{"pillow", shapes::pillow(), 2}});
}

TEST(GaussBonnet, HoldsOnOpenAndOneSidedSurfaces) {
  expect_gauss_bonnet(std::array{
      Case{"open cube", shapes::open_cube(), 1}, Case{"plane", shapes::grid(5, 3), 1},
      Case{"moebius", shapes::moebius_strip(9), 0}, Case{"klein", shapes::klein_bottle(8, 6), 0},
      Case{"projective", shapes::projective_plane(), 1}});
}

TEST(GaussBonnet, HoldsOnComplexesThatAreNoSurfaces) {
  expect_gauss_bonnet(std::array{Case{"vertex", shapes::two_tetrahedra_sharing_vertex(), 3},
                                 Case{"edge", shapes::two_tetrahedra_sharing_edge(), 3},
                                 Case{"face", shapes::two_tetrahedra_sharing_face(), 4},
                                 Case{"fan", shapes::fan_of_three(), 1}});
}

TEST(GaussBonnet, HoldsWhereFacesHaveNoArea) {
  // The torus pressed into a line, a few points, and one; then a zero-area face between others.
  const Soup torus = shapes::torus(2, 0.7, 24, 15);
  Soup line = torus;
  for (Vec3& p : line.positions) p.y() = p.z() = 0.0;
  Soup few = torus;
  for (Vec3& p : few.positions) p = Vec3(std::round(p.x()), 0, 0);
  Soup one = torus;
  for (Vec3& p : one.positions) p.setOnes();
  const Soup thin = shapes::make({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, -2, 0}},
                                 {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 4}});
  expect_gauss_bonnet(std::array{Case{"line", line, 0}, Case{"few points", few, 0},
                                 Case{"one point", one, 0}, Case{"thin", thin, 1}});
}

TEST(GaussBonnet, HoldsAfterAnyDamage) {
  std::mt19937 random(5);
  for (const Index rarity : {2U, 4U, 10U, 50U}) {
    for (int i = 0; i < 10; ++i) {
      const Soup soup = damaged(shapes::torus(2, 0.7, 12, 9), rarity, random);
      EXPECT_NEAR(total_defect(measure_curvature(build(soup))), euler_number(soup), 1e-12);
    }
  }
}

TEST(AngleDefect, CountsTheEdgesOfTheComplexAtEachVertex) {
  std::mt19937 random(8);
  const Soup soup = damaged(shapes::torus(2, 0.7, 12, 9), 4, random);
  const Curvature curvature = measure_curvature(build(soup));
  for (Index v = 0; v < soup.n_vertices(); ++v) {
    std::set<Index> neighbours;
    double expected = 2 * kPi;
    for (const Triangle& t : soup.triangles) {
      const auto at = std::find(t.begin(), t.end(), v);
      if (at == t.end()) continue;
      const auto i = static_cast<std::size_t>(at - t.begin());
      const Vec3 a = soup.positions[t[(i + 1) % 3]] - soup.positions[v];
      const Vec3 b = soup.positions[t[(i + 2) % 3]] - soup.positions[v];
      neighbours.insert({t[(i + 1) % 3], t[(i + 2) % 3]});
      expected += kPi - std::acos(a.dot(b) / (a.norm() * b.norm()));
    }
    expected -= kPi * static_cast<double>(neighbours.size());
    EXPECT_NEAR(curvature.angle_defect[v], expected, 1e-12);
  }
}

TEST(AngleDefect, OnABorderIsTheTurningOfTheBorder) {
  // A rectangle turns by a right angle at its four corners, and nowhere else.
  const Soup plane = shapes::grid(3, 2);
  const Curvature curvature = measure_curvature(build(plane));
  for (std::size_t v = 0; v < plane.n_vertices(); ++v) {
    const Vec3& p = plane.positions[v];
    const bool is_corner = (p.x() == 0 || p.x() == 3) && (p.y() == 0 || p.y() == 2);
    EXPECT_NEAR(curvature.angle_defect[v], is_corner ? kPi / 2 : 0.0, 1e-15);
  }
}

}  // namespace
}  // namespace meshalyzer
