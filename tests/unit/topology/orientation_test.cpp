#include "meshalyzer/topology/orientation.h"

#include "direct_evaluation.h"
#include "meshalyzer/mesh/build.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

Orientability orientability_of(const Soup& soup) {
  const CutMesh cut = build(soup);
  return find_orientability(cut, find_edge_components(cut));
}

/// Turns a third of the faces over.
Soup with_faces_turned(const Soup& soup, std::uint32_t seed) {
  std::vector<Index> faces = shapes::permutation(soup.triangles.size(), seed);
  faces.resize(faces.size() / 3);
  return shapes::flipped(soup, faces);
}

TEST(FindOrientability, EmptyMeshIsOrientable) {
  EXPECT_TRUE(orientability_of(Soup{}).orientable);
  EXPECT_TRUE(orientability_of(Soup{}).of_component.empty());
}

TEST(FindOrientability, TwoSidedSurfacesAreOrientableHoweverTheirFacesAreTurned) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    EXPECT_TRUE(orientability_of(with_faces_turned(shapes::cube(), seed)).orientable);
    EXPECT_TRUE(orientability_of(with_faces_turned(shapes::genus_block(2), seed)).orientable);
    EXPECT_TRUE(orientability_of(with_faces_turned(shapes::grid(5, 5), seed)).orientable);
  }
}

TEST(FindOrientability, OneSidedSurfacesAreNotHoweverTheirFacesAreTurned) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    EXPECT_FALSE(orientability_of(with_faces_turned(shapes::moebius_strip(3), seed)).orientable);
    EXPECT_FALSE(orientability_of(with_faces_turned(shapes::moebius_strip(8), seed)).orientable);
    EXPECT_FALSE(orientability_of(with_faces_turned(shapes::projective_plane(), seed)).orientable);
    EXPECT_FALSE(orientability_of(with_faces_turned(shapes::klein_bottle(5, 4), seed)).orientable);
  }
}

TEST(FindOrientability, IsToldOfEachComponent) {
  const std::vector<Index> turned{0, 5};
  Soup soup = shapes::merged(shapes::flipped(shapes::cube(), turned), shapes::moebius_strip(4));
  soup = shapes::merged(soup, shapes::tetrahedron());
  const Orientability result = orientability_of(soup);
  EXPECT_FALSE(result.orientable);
  EXPECT_EQ(result.of_component, (std::vector<std::uint8_t>{1, 0, 1}));
}

TEST(FindOrientability, EdgeWithMoreThanTwoFacesAsksNothing) {
  EXPECT_TRUE(orientability_of(shapes::fan_of_three()).orientable);
}

TEST(FindOrientability, AgreesWithAllChoicesOnRandomSoups) {
  std::size_t n_one_sided = 0;
  for (std::uint32_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Soup soup = direct::random_soup(seed, 4 + seed % 6);
    soup.positions.resize(4 + seed % 3, Vec3::Zero());
    for (Triangle& t : soup.triangles) {
      for (Index& v : t) v = v == kNoIndex ? v : v % static_cast<Index>(soup.positions.size());
    }
    const direct::Complex complex = direct::complex_of(soup);
    const Orientability result = orientability_of(soup);
    for (Index c = 0; c < result.of_component.size(); ++c) {
      EXPECT_EQ(result.of_component[c] != 0, direct::is_orientable(complex, c));
      n_one_sided += result.of_component[c] == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(n_one_sided, 0U);
}

}  // namespace
}  // namespace meshalyzer
