#include "meshalyzer/analysis/measure_again.h"

#include "meshalyzer/analysis/analyze.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace meshalyzer {
namespace {

void expect_as_analyzed(const Soup& soup) {
  AnalysisOptions options;
  options.keep_values = true;
  const MeasuredValues first = analyze(soup, "soup", options).values;
  const MeasuredValues again = measure_again(soup);
  for (const auto& [quantity, member] : kElementMeasures<std::vector<double>>) {
    EXPECT_EQ(again.*member, first.*member) << quantity.info.key;
  }
}

TEST(MeasureAgain, GivesTheValuesOfTheAnalysisInItsOrder) {
  std::mt19937 random(8);
  expect_as_analyzed(shapes::icosphere(2));
  expect_as_analyzed(damaged(shapes::torus(2, 0.5, 20, 12), 6, random));
  expect_as_analyzed(shapes::two_tetrahedra_sharing_face());
  expect_as_analyzed(
      shapes::merged(shapes::merged(shapes::cube(), shapes::uv_sphere(5, 9)), shapes::open_cube()));
}

TEST(MeasureAgain, GivesOneValueAFaceAnEdgeAndAVertex) {
  const MeasuredValues values = measure_again(shapes::cube());
  EXPECT_EQ(values.vertex_valence.size(), 8U);
  EXPECT_EQ(values.face_area, std::vector<double>(12, 0.5));
  EXPECT_EQ(values.aspect_ratio.size(), 12U);
  EXPECT_EQ(values.corner_angle.size(), 12U);
  EXPECT_EQ(values.edge_length.size(), 18U);
  EXPECT_EQ(values.edge_angle.size(), 18U);
}

TEST(MeasureAgain, BrokenRecordsAreLeftOutAsInTheAnalysis) {
  Soup soup = shapes::cube();
  soup.triangles.push_back({0, 1, 1});
  soup.triangles.push_back({0, 1, kNoIndex});
  soup.missing.push_back({13, 2, 99});
  soup.positions.emplace_back(5, 5, 5);
  // Its corners are in line: zero area, an infinite aspect ratio, no angle.
  soup.positions.emplace_back(6, 6, 6);
  soup.positions.emplace_back(7, 7, 7);
  soup.triangles.push_back({8, 9, 10});
  expect_as_analyzed(soup);
  EXPECT_EQ(measure_again(soup).face_area.size(), 13U);
}

TEST(MeasureAgain, MeshWithoutFacesHasNoValues) {
  expect_as_analyzed(Soup{});
  expect_as_analyzed(shapes::make({{1, 2, 3}}, {}));
  EXPECT_TRUE(measure_again(Soup{}).face_area.empty());
}

}  // namespace
}  // namespace meshalyzer
