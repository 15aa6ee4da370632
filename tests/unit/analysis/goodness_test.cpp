#include "meshalyzer/analysis/goodness.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using Reasons = std::vector<std::string>;

/// Thresholds that every mesh with angles above 0 keeps.
constexpr GoodnessThresholds kLenient{
    .aspect_ratio = 1e300, .edge_angle_degrees = 0, .edge_length = 0};

Goodness goodness(const Soup& soup, const GoodnessThresholds& thresholds = kLenient) {
  AnalysisOptions options;
  options.goodness = thresholds;
  return analyze(soup, "soup", options).goodness.value();
}

Soup with_record(Soup soup, const Triangle& face) {
  soup.triangles.push_back(face);
  return soup;
}

TEST(Judge, CubeIsGood) {
  const Goodness verdict = goodness(shapes::cube());
  EXPECT_TRUE(verdict.good);
  EXPECT_EQ(verdict.reasons, Reasons{});
}

TEST(Judge, CavityThatPointsInwardsIsGood) {
  EXPECT_TRUE(goodness(shapes::nested_cubes(shapes::InnerShell::Cavity)).good);
}

TEST(Judge, AnalysisWithoutThresholdsHasNoVerdict) {
  EXPECT_FALSE(analyze(shapes::cube(), "cube").goodness.has_value());
}

TEST(Judge, OpenMeshIsNotGood) {
  const Goodness verdict = goodness(shapes::open_cube());
  EXPECT_FALSE(verdict.good);
  EXPECT_EQ(verdict.reasons,
            (Reasons{"not closed", "outward is undefined: the mesh is not closed"}));
}

TEST(Judge, NonManifoldMeshIsNotGood) {
  EXPECT_EQ(goodness(shapes::two_tetrahedra_sharing_vertex()).reasons,
            (Reasons{"not manifold", "outward is undefined: the mesh is not manifold"}));
}

TEST(Judge, InwardMeshIsNotGood) {
  EXPECT_EQ(goodness(shapes::flipped(shapes::cube())).reasons, Reasons{"not outward"});
}

TEST(Judge, InconsistentMeshHasNoOutside) {
  const std::vector<Index> turned{4};
  EXPECT_EQ(goodness(shapes::flipped(shapes::cube(), turned)).reasons,
            Reasons{"outward is undefined: the mesh is not consistently oriented"});
}

TEST(Judge, IntersectingFacesAreCounted) {
  // The corner of the second, (0.2, 0.2, 0.2), is inside the first: its three faces there cross the
  // slanted face of the first.
  const Soup soup = shapes::merged(shapes::tetrahedron(),
                                   shapes::translated(shapes::tetrahedron(), Vec3::Constant(0.2)));
  EXPECT_EQ(goodness(soup).reasons, Reasons{"intersecting pairs of faces: 3"});
}

TEST(Judge, OrphanVertexIsNotGood) {
  Soup soup = shapes::cube();
  soup.positions.emplace_back(5, 5, 5);
  EXPECT_EQ(goodness(soup).reasons, Reasons{"orphan vertices: 1"});
}

TEST(Judge, MissingVertexIsNotGood) {
  Soup soup = with_record(shapes::cube(), {0, 1, kNoIndex});
  soup.missing.push_back({12, 2, 99});
  EXPECT_EQ(goodness(soup).reasons, Reasons{"missing vertices: 1"});
}

TEST(Judge, DegenerateFaceIsNotGood) {
  EXPECT_EQ(goodness(with_record(shapes::cube(), {0, 1, 1})).reasons,
            Reasons{"degenerate faces: 1"});
}

TEST(Judge, BrokenNumberingIsNotGood) {
  Soup soup = shapes::cube();
  soup.vertex_ids.named = {1, 2, 3, 4, 5, 6, 7, 9};
  EXPECT_EQ(goodness(soup).reasons, Reasons{"vertex numbering is not contiguous"});
  soup = shapes::cube();
  soup.face_ids.named = {2, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  EXPECT_EQ(goodness(soup).reasons, Reasons{"face numbering is not contiguous"});
}

TEST(Judge, TornLineIsNotGood) {
  Soup soup = shapes::cube();
  soup.torn_lines = {4};
  EXPECT_EQ(goodness(soup).reasons, Reasons{"torn lines: 1"});
}

TEST(Judge, ThresholdsAreStrict) {
  // A half square's aspect ratio is sqrt 2 / (1 / sqrt 2); the cube's angles are 180 and 270, its
  // shortest edges 1.
  GoodnessThresholds limits = kLenient;
  limits.aspect_ratio = 1.999;
  EXPECT_EQ(goodness(shapes::cube(), limits).reasons.size(), 1U);
  limits.aspect_ratio = 2.001;
  EXPECT_TRUE(goodness(shapes::cube(), limits).good);
  limits.edge_angle_degrees = 180;
  EXPECT_EQ(goodness(shapes::cube(), limits).reasons,
            Reasons{"smallest edge angle 180 is not above 180"});
  limits.edge_angle_degrees = 179.999;
  EXPECT_TRUE(goodness(shapes::cube(), limits).good);
  limits.edge_length = 1;
  EXPECT_EQ(goodness(shapes::cube(), limits).reasons,
            Reasons{"shortest edge 1 is not longer than 1"});
  limits.edge_length = 0.999;
  EXPECT_TRUE(goodness(shapes::cube(), limits).good);
}

TEST(Judge, ReasonsStandInTheOrderOfTheContract) {
  Soup soup = with_record(with_record(shapes::open_cube(), {0, 1, 1}), {0, 1, kNoIndex});
  soup.missing.push_back({11, 2, 99});
  soup.positions.emplace_back(5, 5, 5);
  soup.vertex_ids.named = {1, 2, 3, 4, 5, 6, 7, 8, 10};
  const GoodnessThresholds strict{.aspect_ratio = 1, .edge_angle_degrees = 180, .edge_length = 2};
  const Reasons reasons = goodness(soup, strict).reasons;
  ASSERT_EQ(reasons.size(), 9U);
  EXPECT_EQ(reasons[0], "not closed");
  EXPECT_EQ(reasons[1], "outward is undefined: the mesh is not closed");
  EXPECT_EQ(reasons[2], "orphan vertices: 1");
  EXPECT_EQ(reasons[3], "missing vertices: 1");
  EXPECT_EQ(reasons[4], "degenerate faces: 1");
  EXPECT_EQ(reasons[5], "vertex numbering is not contiguous");
  EXPECT_EQ(reasons[6].substr(0, 20), "largest aspect ratio");
  EXPECT_EQ(reasons[7], "smallest edge angle 180 is not above 180");
  EXPECT_EQ(reasons[8], "shortest edge 1 is not longer than 2");
}

TEST(Judge, ZeroAreaFaceExceedsAnyAspectRatio) {
  // One face with its corners in line.
  const Goodness verdict = goodness(shapes::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}));
  EXPECT_EQ(verdict.reasons, (Reasons{"not closed", "outward is undefined: the mesh is not closed",
                                      "faces of infinite aspect ratio: 1"}));
}

TEST(Judge, NoFacesAreNotGood) {
  const Goodness verdict = goodness(Soup{});
  EXPECT_FALSE(verdict.good);
  EXPECT_EQ(verdict.reasons,
            (Reasons{"closed is undefined: no faces", "manifold is undefined: no faces",
                     "outward is undefined: no faces"}));
}

/// All that can be wrong without a threshold, and a mesh with nothing wrong.
std::vector<Soup> fit_and_unfit() {
  Soup orphan = shapes::cube();
  orphan.positions.emplace_back(5, 5, 5);
  Soup torn = shapes::cube();
  torn.torn_lines = {4};
  Soup numbering = shapes::cube();
  numbering.vertex_ids.named = {1, 2, 3, 4, 5, 6, 7, 9};
  return {shapes::cube(),
          shapes::open_cube(),
          shapes::flipped(shapes::cube()),
          shapes::two_tetrahedra_sharing_vertex(),
          shapes::merged(shapes::tetrahedron(),
                         shapes::translated(shapes::tetrahedron(), Vec3::Constant(0.2))),
          with_record(shapes::cube(), {0, 1, 1}),
          orphan,
          torn,
          numbering,
          Soup{}};
}

TEST(JudgeFitness, IsGoodnessWhereThresholdsAllowEverything) {
  for (const Soup& soup : fit_and_unfit()) {
    const Goodness fitness = analyze(soup, "soup").fitness.value();
    EXPECT_EQ(fitness.reasons, goodness(soup).reasons);
    EXPECT_EQ(fitness.good, fitness.reasons.empty());
  }
  EXPECT_TRUE(analyze(shapes::cube(), "cube").fitness.value().good);
}

TEST(JudgeFitness, ThresholdsDoNotCount) {
  AnalysisOptions strict;
  strict.goodness = {.aspect_ratio = 1, .edge_angle_degrees = 350, .edge_length = 9};
  const Analysis cube = analyze(shapes::cube(), "cube", strict);
  EXPECT_FALSE(cube.goodness.value().good);
  EXPECT_TRUE(cube.fitness.value().good);
}

TEST(JudgeFitness, AttributesAloneGiveTheSameVerdictWhereAskedFor) {
  AnalysisOptions options;
  options.scope = Scope::AttributesOnly;
  for (const Soup& soup : fit_and_unfit()) {
    EXPECT_FALSE(analyze(soup, "soup", options).fitness.has_value());
    AnalysisOptions judging = options;
    judging.judge_fitness = true;
    EXPECT_EQ(analyze(soup, "soup", judging).fitness.value().reasons,
              analyze(soup, "soup").fitness.value().reasons);
  }
}

}  // namespace
}  // namespace meshalyzer
