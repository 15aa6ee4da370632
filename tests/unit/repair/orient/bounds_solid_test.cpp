#include "meshalyzer/repair/orient/bounds_solid.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace meshalyzer {
namespace {

using Answers = std::vector<std::uint8_t>;

Answers answers(const Soup& soup) {
  const PreparedMesh mesh(soup);
  return bounds_solid(mesh, find_components(mesh.cut()));
}

/// Returns a mesh without the faces that lie wholly below a height.
Soup above(Soup soup, double z) {
  std::vector<Index> below;
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    bool is_below = true;
    for (const Index v : soup.triangles[f]) is_below = is_below && soup.positions[v].z() <= z;
    if (is_below) below.push_back(static_cast<Index>(f));
  }
  return shapes::without_faces(std::move(soup), below);
}

/// A tube of radius 1 round the z axis, open at both ends.
Soup tube(std::size_t n_rings, double length) {
  constexpr std::size_t kSides = 24;
  Soup soup = shapes::grid(kSides, n_rings);
  for (Vec3& p : soup.positions) {
    const double angle = 2.0 * std::numbers::pi * p.x() / kSides;
    p = {std::cos(angle), std::sin(angle), length * p.y() / static_cast<double>(n_rings)};
  }
  for (Triangle& t : soup.triangles) {
    for (Index& v : t) v = v % (kSides + 1) == kSides ? v - static_cast<Index>(kSides) : v;
  }
  return soup;
}

TEST(MeansSolid, EmptyMeshHasNoComponents) {
  EXPECT_TRUE(answers(Soup{}).empty());
}

TEST(MeansSolid, ClosedSurfacesAlwaysDo) {
  for (const Soup& soup : {shapes::cube(), shapes::icosphere(2), shapes::pillow(),
                           shapes::klein_bottle(6, 6), shapes::two_tetrahedra_sharing_edge()}) {
    EXPECT_EQ(answers(soup), Answers{1});
  }
}

TEST(MeansSolid, CubeWithoutASideDoesWhicheverWayItFaces) {
  EXPECT_EQ(answers(shapes::open_cube()), Answers{1});
  EXPECT_EQ(answers(shapes::flipped(shapes::open_cube())), Answers{1});
}

TEST(MeansSolid, HemisphereDoesButAShallowCapDoesNot) {
  // On a cap of the half angle t the winding number is sin(t / 2) / 2 at the pole and t / (2 pi) at
  // the rim: 0.32 and 0.22 at 80 degrees, where most of the area has more than 1/4, and 0.19 and
  // 0.125 at 45 degrees.
  EXPECT_EQ(answers(above(shapes::uv_sphere(40, 40), 0.0)), Answers{1});
  EXPECT_EQ(answers(above(shapes::uv_sphere(36, 40), std::cos(4.0 * std::numbers::pi / 9.0))),
            Answers{1});
  EXPECT_EQ(answers(above(shapes::uv_sphere(40, 40), std::sqrt(0.5))), Answers{0});
}

TEST(MeansSolid, SheetsDoNot) {
  Soup hills = shapes::grid(20, 20);
  for (Vec3& p : hills.positions) p.z() = std::sin(0.5 * p.x()) + std::cos(0.4 * p.y());
  for (const Soup& soup : {shapes::grid(1, 1), shapes::grid(9, 9), hills, shapes::fan_of_three(),
                           shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}),
                           shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 1}},
                                        {{0, 1, 2}, {0, 3, 4}})}) {
    EXPECT_EQ(answers(soup), Answers{0});
  }
}

TEST(MeansSolid, LongTubeDoesAndAShortRingDoesNot) {
  EXPECT_EQ(answers(tube(20, 10.0)), Answers{1});
  EXPECT_EQ(answers(tube(2, 0.25)), Answers{0});
}

TEST(MeansSolid, MoebiusStripDoesNot) {
  EXPECT_EQ(answers(shapes::moebius_strip(30)), Answers{0});
}

TEST(MeansSolid, FacesAreJudgedAsTheirFlippedEdgesAsk) {
  const Soup box = shapes::open_cube();
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    std::vector<Index> turned = shapes::permutation(box.n_faces(), seed);
    turned.resize(5);
    EXPECT_EQ(answers(shapes::flipped(box, turned)), Answers{1});
  }
}

TEST(MeansSolid, ComponentsAreJudgedEachByItself) {
  const Soup soup = shapes::merged(shapes::merged(shapes::grid(4, 4), shapes::open_cube()),
                                   shapes::cube(1.0, {9, 0, 0}));
  EXPECT_EQ(answers(soup), (Answers{0, 1, 1}));
}

TEST(MeansSolid, LargeSurfaceIsJudgedByItsAreaNotByItsFaces) {
  // A large box without a lid, area 500, of ten faces; far from it a fine sheet of area 400.
  const Soup box = shapes::merged(shapes::scaled(shapes::open_cube(), 10.0),
                                  shapes::translated(shapes::grid(20, 20), {0, 0, 1000}));
  const PreparedMesh mesh(box);
  const Components all{.count = 1, .of_face = std::vector<Index>(box.n_faces(), 0)};
  EXPECT_EQ(bounds_solid(mesh, all), Answers{1});
  // And the other way round: a large sheet, and a fine small sphere that lacks a face.
  const Soup ball = shapes::without_faces(shapes::icosphere(3), std::array{Index{0}});
  const Soup sheet = shapes::merged(shapes::scaled(shapes::grid(2, 2), 50.0),
                                    shapes::translated(ball, {50, 50, 20}));
  const PreparedMesh mesh_of_sheet(sheet);
  EXPECT_EQ(
      bounds_solid(mesh_of_sheet, {.count = 1, .of_face = std::vector<Index>(sheet.n_faces(), 0)}),
      Answers{0});
}

TEST(MeansSolid, SurfaceWithoutAreaDoesNot) {
  EXPECT_EQ(answers(shapes::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})), Answers{0});
}

TEST(MeansSolid, SizeIsNoMatter) {
  for (const double size : {1e-318, 1e-200, 1e200, 1e307}) {
    EXPECT_EQ(answers(shapes::scaled(shapes::open_cube(), size)), Answers{1});
    EXPECT_EQ(answers(shapes::scaled(shapes::grid(3, 3), size)), Answers{0});
  }
}

}  // namespace
}  // namespace meshalyzer
