#include "meshalyzer/set/set_object.h"

#include "direct_evaluation.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <ostream>
#include <random>
#include <vector>

namespace meshalyzer {

void PrintTo(Side side, std::ostream* out) {
  *out << (side == Side::Outside ? "outside" : side == Side::Inside ? "inside" : "on the surface");
}

namespace {

/// Multiples of 1/4 in a cube from -1 to 4: many are on sides, edges and corners of unit cubes.
Vec3 lattice_point(std::mt19937& random) {
  const auto coordinate = [&] { return static_cast<double>(random() % 21) / 4 - 1; };
  const double x = coordinate();
  const double y = coordinate();
  return {x, y, coordinate()};
}

/// The side of the cube [low, high]^3 that a point lies on.
Side side_of_cube(const Vec3& p, double low, double high) {
  if ((p.array() > low).all() && (p.array() < high).all()) {
    return Side::Inside;
  }
  return (p.array() >= low).all() && (p.array() <= high).all() ? Side::OnSurface : Side::Outside;
}

template <typename Truth>
void expect_sides(const Soup& soup, const Truth& truth) {
  const SetObject object(soup);
  std::mt19937 random(3);
  std::array<int, 3> n_seen{};
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = lattice_point(random);
    const Side expected = truth(p);
    ++n_seen[static_cast<std::size_t>(expected)];
    EXPECT_EQ(object.side_of(p), expected) << p.transpose();
  }
  EXPECT_GT(*std::min_element(n_seen.begin(), n_seen.end()), 20);
}

TEST(SideOf, CubeIsTheNumbersBetweenItsSides) {
  expect_sides(shapes::cube(3.0), [](const Vec3& p) { return side_of_cube(p, 0, 3); });
}

TEST(SideOf, CavityIsOutsideWhicheverWayItsWallPoints) {
  const auto truth = [](const Vec3& p) {
    const Side inner = side_of_cube(p, 1, 2);
    return inner == Side::Outside     ? side_of_cube(p, 0, 3)
           : inner == Side::OnSurface ? Side::OnSurface
                                      : Side::Outside;
  };
  expect_sides(shapes::nested_cubes(shapes::InnerShell::Cavity), truth);
  expect_sides(shapes::nested_cubes(shapes::InnerShell::Outward), truth);
}

TEST(SideOf, TurnedOverFacesEncloseAsMuch) {
  const auto truth = [](const Vec3& p) { return side_of_cube(p, 0, 3); };
  expect_sides(shapes::flipped(shapes::cube(3.0)), truth);
  expect_sides(shapes::flipped(shapes::cube(3.0), std::array<Index, 1>{4}), truth);
}

TEST(SideOf, SheetInASolidIsNoPartOfIt) {
  // The sheet cuts the cube in two, and a ray along x meets it.
  Soup sheet = shapes::grid(5, 5);
  for (Vec3& p : sheet.positions) {
    p = Vec3(1.5, p.x() - 1, p.y() - 1);
  }
  expect_sides(shapes::merged(sheet, shapes::cube(3.0)),
               [](const Vec3& p) { return side_of_cube(p, 0, 3); });
}

TEST(SideOf, EqualsExactParityOnCurvedSurfaces) {
  std::mt19937 random(5);
  std::uniform_real_distribution<> real(-1.1, 1.1);
  for (const Soup& soup :
       {shapes::icosphere(1), shapes::torus(1, 0.6, 9, 6),
        shapes::merged(shapes::uv_sphere(5, 7), shapes::scaled(shapes::icosphere(0), 0.5))}) {
    const SetObject object(soup);
    const std::vector<Triangle> faces = test::enclosing_faces(soup);
    int n_inside = 0;
    for (int i = 0; i < 80; ++i) {
      const Vec3 p(real(random), real(random), real(random) / 2);
      EXPECT_EQ(object.side_of(p), test::direct_side(soup, faces, p)) << p.transpose();
      n_inside += object.side_of(p) == Side::Inside ? 1 : 0;
    }
    EXPECT_GT(n_inside, 10);
    for (const Vec3& p : soup.positions) {
      EXPECT_EQ(object.side_of(p), Side::OnSurface);
    }
  }
}

TEST(SideOf, OneUlpDecides) {
  const SetObject object(shapes::cube(3.0));
  EXPECT_EQ(object.side_of({1, std::nextafter(3.0, 4.0), 1}), Side::Outside);
  EXPECT_EQ(object.side_of({1, 3, 1}), Side::OnSurface);
  EXPECT_EQ(object.side_of({1, std::nextafter(3.0, 2.0), 1}), Side::Inside);
}

TEST(SideOf, OpenMeshEnclosesNothing) {
  for (const Soup& soup : {shapes::open_cube(), shapes::grid(2, 2), shapes::moebius_strip(7)}) {
    const SetObject object(soup);
    EXPECT_FALSE(object.is_solid());
    EXPECT_EQ(object.side_of(Vec3::Constant(0.5)), Side::Outside);
    EXPECT_EQ(object.side_of(soup.positions.front()), Side::Outside);
  }
}

TEST(IsSolid, EveryEdgeMustHaveTwoFaces) {
  EXPECT_TRUE(SetObject(shapes::cube()).is_solid());
  EXPECT_TRUE(SetObject(shapes::two_tetrahedra_sharing_vertex()).is_solid());
  EXPECT_TRUE(SetObject(shapes::projective_plane()).is_solid());
  EXPECT_FALSE(SetObject(shapes::two_tetrahedra_sharing_edge()).is_solid());
  EXPECT_FALSE(SetObject(shapes::two_tetrahedra_sharing_face()).is_solid());
  EXPECT_FALSE(SetObject(shapes::fan_of_three()).is_solid());
  EXPECT_FALSE(SetObject(Soup()).is_solid());
}

TEST(IsSolid, OneComponentIsEnough) {
  EXPECT_TRUE(SetObject(shapes::merged(shapes::fan_of_three(), shapes::cube())).is_solid());
}

TEST(SetObject, EachComponentHasItsBoxAndOneOfItsVertices) {
  const Vec3 away(10, 20, 30);
  const SetObject object(
      shapes::merged(shapes::cube(2.0), shapes::translated(shapes::tetrahedron(), away)));
  ASSERT_EQ(object.components().count, 2U);
  EXPECT_TRUE(object.component_boxes()[0].isApprox(Box3(Vec3::Zero(), Vec3::Constant(2)), 0));
  EXPECT_TRUE(object.component_boxes()[1].isApprox(Box3(away, away + Vec3::Ones()), 0));
  EXPECT_LT(object.component_vertices()[0], 8U);
  EXPECT_GE(object.component_vertices()[1], 8U);
  EXPECT_TRUE(object.box().isApprox(Box3(Vec3::Zero(), away + Vec3::Ones()), 0));
}

TEST(SetObject, OnlyVerticesThatFacesUseCount) {
  // The vertex at (9, 9, 9) is named only by a face that names it twice.
  Soup soup = shapes::cube();
  soup.positions.insert(soup.positions.begin(), Vec3(9, 9, 9));
  for (Triangle& t : soup.triangles) {
    t = {t[0] + 1, t[1] + 1, t[2] + 1};
  }
  soup.triangles.insert(soup.triangles.begin(), {0, 0, 1});
  const SetObject object(soup);
  EXPECT_TRUE(object.box().isApprox(Box3(Vec3::Zero(), Vec3::Ones()), 0));
  EXPECT_NE(object.component_vertices().at(0), 0U);
  EXPECT_EQ(object.side_of(Vec3::Constant(0.5)), Side::Inside);
}

TEST(SetObject, MeshWithoutFacesIsNowhere) {
  for (const Soup& soup : {Soup(), shapes::make({{1, 2, 3}}, {})}) {
    const SetObject object(soup, ClosestUse::Prepared);
    EXPECT_TRUE(object.box().isEmpty());
    EXPECT_EQ(object.components().count, 0U);
    EXPECT_EQ(object.side_of({1, 2, 3}), Side::Outside);
    EXPECT_FALSE(object.closest().find({.point = {1, 2, 3}}).has_value());
  }
}

TEST(SetObject, KeepsTheIdsOfTheFile) {
  Soup soup = shapes::tetrahedron();
  soup.vertex_ids.named = {4, 3, 2, 9};
  soup.face_ids.first = 0;
  const SetObject object(soup);
  EXPECT_EQ(object.vertex_ids().of(3), 9);
  EXPECT_EQ(object.face_ids().of(3), 3);
}

TEST(SetObject, MeshThatIsTakenOverIsTheSameObject) {
  Soup soup = shapes::merged(shapes::tetrahedron(), shapes::icosphere(2));
  soup.face_ids.first = 0;
  const SetObject built(soup, ClosestUse::Prepared);
  auto mesh = std::make_shared<PreparedMesh>(soup);
  mesh->release_soup();
  const SetObject taken(mesh, soup.vertex_ids, soup.face_ids, ClosestUse::Prepared);
  EXPECT_EQ(&taken.tree(), &mesh->tree());
  EXPECT_EQ(taken.bytes(), built.bytes());
  EXPECT_EQ(taken.component_vertices(), built.component_vertices());
  EXPECT_EQ(taken.face_ids().of(3), 3);
  EXPECT_TRUE(taken.box().isApprox(built.box(), 0));
  EXPECT_EQ(taken.side_of(Vec3::Zero()), built.side_of(Vec3::Zero()));
  const Vec3 away(3, 1, 2);
  EXPECT_EQ(taken.closest().find({.point = away})->point,
            built.closest().find({.point = away})->point);
}

TEST(SetObject, MemoryGrowsWithFacesAndWithWhatIsPrepared) {
  const Soup sphere = shapes::icosphere(3);
  const std::uint64_t plain = SetObject(sphere).bytes();
  // Four times the faces, but for what does not depend on them, most of which is the object itself;
  // and to be asked for closest points 36 bytes a face for its corners, and 480 for the boxes of
  // eight leaves of eight faces: see FaceTree and ClosestPoints.
  const auto that_grows = [](std::uint64_t bytes) {
    return static_cast<double>(bytes - sizeof(SetObject) - sizeof(PreparedMesh));
  };
  EXPECT_NEAR(that_grows(SetObject(shapes::icosphere(4)).bytes()), 4 * that_grows(plain), 4096);
  EXPECT_EQ(SetObject(sphere, ClosestUse::Prepared).bytes(),
            plain + 36 * sphere.n_faces() + 480 * sphere.n_faces() / 64);
}

}  // namespace
}  // namespace meshalyzer
