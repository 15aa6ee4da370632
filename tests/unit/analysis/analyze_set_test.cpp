#include "meshalyzer/analysis/analyze.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace meshalyzer {
namespace {

AnalysisOptions judged() {
  AnalysisOptions options;
  options.goodness = {.aspect_ratio = 100, .edge_angle_degrees = 0, .edge_length = 0};
  return options;
}

TEST(AnalyzeSet, NoMeshesAddUpToNothing) {
  const SetAnalysis set = analyze_set({}, 0);
  EXPECT_EQ(set.meshes, 0U);
  EXPECT_EQ(set.faces, 0U);
  EXPECT_EQ(set.area, 0.0);
  EXPECT_FALSE(set.volume.value.has_value());
}

TEST(AnalyzeSet, CountsAndMeasuresAddUp) {
  // Two cubes and a cavity: V 8 + 8 + 16, E 18 + 18 + 36, F 12 + 12 + 24, areas 6 + 24 + 60,
  // volumes 1 - 8 + 26.
  const std::vector<Analysis> meshes{
      analyze(shapes::cube(), "a", judged()),
      analyze(shapes::flipped(shapes::cube(2.0)), "b", judged()),
      analyze(shapes::nested_cubes(shapes::InnerShell::Cavity), "c", judged())};
  const SetAnalysis set = analyze_set(meshes, 2);
  EXPECT_EQ(set.meshes, 3U);
  EXPECT_EQ(set.unreadable, 2U);
  EXPECT_EQ(set.good, 2U);
  EXPECT_EQ(set.vertices, 32U);
  EXPECT_EQ(set.edges, 72U);
  EXPECT_EQ(set.faces, 48U);
  EXPECT_EQ(set.components, 4U);
  EXPECT_EQ(set.boundaries, 0U);
  EXPECT_EQ(set.intersecting_pairs_within, 0U);
  EXPECT_NEAR(set.area, 90.0, 1e-12);
  EXPECT_NEAR(set.volume.value.value(), 19.0, 1e-12);
  EXPECT_EQ(set.volume.reason, "");
}

TEST(AnalyzeSet, MeshesWithoutVolumeAreSaid) {
  const std::vector<Analysis> meshes{analyze(shapes::cube(), "a"), analyze(shapes::grid(2, 2), "b"),
                                     analyze(Soup{}, "c")};
  const SetAnalysis set = analyze_set(meshes, 0);
  EXPECT_NEAR(set.volume.value.value(), 1.0, 1e-14);
  EXPECT_EQ(set.volume.reason, "meshes without a volume: 2");
  EXPECT_EQ(set.boundaries, 1U);
}

TEST(AnalyzeSet, NoMeshWithVolumeLeavesNone) {
  const std::vector<Analysis> meshes{analyze(shapes::grid(2, 2), "a")};
  const SetAnalysis set = analyze_set(meshes, 0);
  EXPECT_FALSE(set.volume.value.has_value());
  EXPECT_EQ(set.volume.reason, "meshes without a volume: 1");
}

TEST(AnalyzeSet, PairsWithinMeshesAddUp) {
  // Three pairs each: see the corner of the second tetrahedron in the first.
  const Soup soup = shapes::merged(shapes::tetrahedron(),
                                   shapes::translated(shapes::tetrahedron(), Vec3::Constant(0.2)));
  const std::vector<Analysis> meshes{analyze(soup, "a"), analyze(soup, "b")};
  EXPECT_EQ(analyze_set(meshes, 0).intersecting_pairs_within, 6U);
}

}  // namespace
}  // namespace meshalyzer
