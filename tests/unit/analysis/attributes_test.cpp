#include "meshalyzer/analysis/internal/attributes.h"

#include "meshalyzer/analysis/analyze.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

void expect_undefined(const Answer& answer, const std::string& reason) {
  EXPECT_FALSE(answer.value.has_value());
  EXPECT_EQ(answer.reason, reason);
}

/// Expects that no attribute, volume or genus is defined.
void expect_nothing_defined(const Analysis& analysis) {
  const Attributes& a = analysis.attributes;
  for (const Answer& answer : {a.closed, a.manifold, a.orientable, a.consistent, a.outward}) {
    expect_undefined(answer, "no faces");
  }
  const Characteristics& c = analysis.characteristics;
  EXPECT_FALSE(c.volume.value.has_value());
  EXPECT_EQ(c.volume.reason, "no faces");
  EXPECT_FALSE(c.genus.value.has_value());
  EXPECT_EQ(c.genus.reason, "no faces");
  EXPECT_FALSE(c.genus_of_components.has_value());
  EXPECT_TRUE(c.bounding_box.isEmpty());
  EXPECT_EQ(c.components, 0U);
}

TEST(AnswerAttributes, EmptyFileHasNone) {
  expect_nothing_defined(analyze(Soup{}, "empty"));
}

TEST(AnswerAttributes, PointCloudHasNone) {
  const Analysis analysis = analyze(shapes::make({{0, 0, 0}, {1, 2, 3}}, {}), "points");
  expect_nothing_defined(analysis);
  EXPECT_EQ(analysis.integrity.orphan_vertices, 2U);
  EXPECT_EQ(analysis.characteristics.vertices, 2U);
}

TEST(AnswerAttributes, OnlyDegenerateFacesHaveNone) {
  const Analysis analysis = analyze(shapes::make({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}), "line");
  expect_nothing_defined(analysis);
  EXPECT_EQ(analysis.characteristics.faces, 1U);
  EXPECT_EQ(analysis.integrity.degenerate_faces, 1U);
}

TEST(AnswerAttributes, CubeHasAllWithoutReasons) {
  const Attributes a = analyze(shapes::cube(), "cube").attributes;
  for (const Answer& answer : {a.closed, a.manifold, a.orientable, a.consistent, a.outward}) {
    EXPECT_EQ(answer.value, true);
    EXPECT_EQ(answer.reason, "");
  }
}

TEST(AnswerAttributes, OpenMeshIsNotClosedAndHasNoOutside) {
  const Analysis analysis = analyze(shapes::open_cube(), "open");
  EXPECT_EQ(analysis.attributes.closed.value, false);
  EXPECT_EQ(analysis.attributes.manifold.value, true);
  EXPECT_EQ(analysis.attributes.consistent.value, true);
  expect_undefined(analysis.attributes.outward, "the mesh is not closed");
  EXPECT_EQ(analysis.characteristics.volume.reason, "the mesh is not closed");
  EXPECT_EQ(analysis.characteristics.genus.value, 0);
}

TEST(AnswerAttributes, NonManifoldMeshHasOnlyClosedness) {
  const Analysis analysis = analyze(shapes::two_tetrahedra_sharing_edge(), "edge");
  EXPECT_EQ(analysis.attributes.closed.value, true);
  EXPECT_EQ(analysis.attributes.manifold.value, false);
  expect_undefined(analysis.attributes.orientable, "the mesh is not manifold");
  expect_undefined(analysis.attributes.consistent, "the mesh is not manifold");
  expect_undefined(analysis.attributes.outward, "the mesh is not manifold");
  EXPECT_EQ(analysis.characteristics.volume.reason, "the mesh is not manifold");
  EXPECT_EQ(analysis.characteristics.genus.reason, "the mesh is not manifold");
}

TEST(AnswerAttributes, OneTurnedFaceIsInconsistentButOrientable) {
  const std::vector<Index> turned{7};
  const Analysis analysis = analyze(shapes::flipped(shapes::cube(), turned), "turned");
  EXPECT_EQ(analysis.attributes.orientable.value, true);
  EXPECT_EQ(analysis.attributes.consistent.value, false);
  expect_undefined(analysis.attributes.outward, "the mesh is not consistently oriented");
  EXPECT_EQ(analysis.characteristics.volume.reason, "the mesh is not consistently oriented");
  EXPECT_EQ(analysis.characteristics.flipped_edges, 3U);
  EXPECT_EQ(analysis.characteristics.genus.value, 0);
}

TEST(AnswerAttributes, KleinBottleIsClosedManifoldAndNotOrientable) {
  const Analysis analysis = analyze(shapes::klein_bottle(6, 5), "bottle");
  EXPECT_EQ(analysis.attributes.closed.value, true);
  EXPECT_EQ(analysis.attributes.manifold.value, true);
  EXPECT_EQ(analysis.attributes.orientable.value, false);
  EXPECT_EQ(analysis.attributes.consistent.value, false);
  expect_undefined(analysis.attributes.outward, "the mesh is not consistently oriented");
  EXPECT_FALSE(analysis.characteristics.genus.value.has_value());
  EXPECT_EQ(analysis.characteristics.genus.reason, "the mesh is not orientable");
}

TEST(AnswerAttributes, PillowEnclosesNoVolume) {
  const Analysis analysis = analyze(shapes::pillow(), "pillow");
  EXPECT_EQ(analysis.attributes.consistent.value, true);
  expect_undefined(analysis.attributes.outward, "it encloses no volume");
  EXPECT_EQ(analysis.characteristics.volume.value, 0.0);
  EXPECT_EQ(analysis.characteristics.genus.value, 0);
}

TEST(AnswerAttributes, PillowBesideACubeLeavesTheMeshUndecided) {
  const Soup soup = shapes::merged(shapes::cube(), shapes::translated(shapes::pillow(), {5, 5, 5}));
  expect_undefined(analyze(soup, "both").attributes.outward,
                   "components that enclose no volume: 1");
}

TEST(AnswerAttributes, PillowBesideAnInwardCubeIsNotOutward) {
  const Soup soup = shapes::merged(shapes::flipped(shapes::cube()),
                                   shapes::translated(shapes::pillow(), {5, 5, 5}));
  EXPECT_EQ(analyze(soup, "both").attributes.outward.value, false);
}

TEST(AnswerAttributes, OneOpenComponentOpensTheMesh) {
  const Soup soup =
      shapes::merged(shapes::cube(), shapes::translated(shapes::grid(1, 1), {5, 5, 5}));
  const Analysis analysis = analyze(soup, "both");
  EXPECT_EQ(analysis.attributes.closed.value, false);
  EXPECT_TRUE(analysis.components.at(0).closed);
  EXPECT_EQ(analysis.components.at(0).outward, true);
  EXPECT_FALSE(analysis.components.at(1).closed);
  EXPECT_FALSE(analysis.components.at(1).outward.has_value());
  EXPECT_FALSE(analysis.components.at(1).volume.has_value());
}

TEST(AnswerGenus, OrphanVertexForbidsTheMeshsButNotTheComponents) {
  Soup soup = shapes::torus(2, 0.5, 6, 5);
  soup.positions.emplace_back(9, 9, 9);
  const Characteristics c = analyze(soup, "torus").characteristics;
  EXPECT_FALSE(c.genus.value.has_value());
  EXPECT_EQ(c.genus.reason, "orphan vertices: 1");
  EXPECT_EQ(c.genus_of_components, 1);
}

TEST(AnswerGenus, ComponentsAddUp) {
  const Soup soup = shapes::merged(shapes::genus_block(2),
                                   shapes::translated(shapes::torus(2, 0.5, 6, 5), {20, 20, 20}));
  const Analysis analysis = analyze(soup, "both");
  EXPECT_EQ(analysis.characteristics.genus.value, 3);
  EXPECT_EQ(analysis.components.at(0).genus, 2);
  EXPECT_EQ(analysis.components.at(1).genus, 1);
}

TEST(AnswerGenus, BoundariesCountAsDiscs) {
  // A block with two holes that lost a face, and another far from it: 2 - 2 genus - boundaries.
  const std::vector<Index> out{0, 40};
  const Characteristics c =
      analyze(shapes::without_faces(shapes::genus_block(2), out), "block").characteristics;
  EXPECT_EQ(c.boundaries, 2U);
  EXPECT_EQ(c.genus.value, 2);
}

}  // namespace
}  // namespace meshalyzer
