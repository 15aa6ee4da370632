#include "meshalyzer/analysis/internal/by_component.h"

#include "meshalyzer/analysis/analyze.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

void expect_same(const Summary& a, const Summary& b) {
  EXPECT_EQ(a.count, b.count);
  EXPECT_EQ(a.infinite, b.infinite);
  EXPECT_DOUBLE_EQ(a.min, b.min);
  EXPECT_DOUBLE_EQ(a.max, b.max);
  EXPECT_DOUBLE_EQ(a.mean, b.mean);
  EXPECT_DOUBLE_EQ(a.median, b.median);
  EXPECT_NEAR(a.variance, b.variance, 1e-12 * (1 + b.variance));
  EXPECT_DOUBLE_EQ(a.total, b.total);
}

/// Expects that a component of a mesh has the figures that it has alone in a file.
void expect_component(const Analysis& whole, std::size_t i, const Soup& alone) {
  SCOPED_TRACE(i);
  const Analysis part = analyze(alone, "alone");
  const ComponentAnalysis& component = whole.components.at(i);
  EXPECT_EQ(component.faces, part.characteristics.faces);
  EXPECT_EQ(component.vertices, part.characteristics.vertices);
  EXPECT_EQ(component.edges, part.characteristics.edges);
  EXPECT_EQ(component.boundaries, part.characteristics.boundaries);
  EXPECT_EQ(component.border_edges, part.characteristics.border_edges);
  EXPECT_EQ(component.non_manifold_edges, part.characteristics.non_manifold_edges);
  EXPECT_EQ(component.non_manifold_vertices, part.characteristics.non_manifold_vertices);
  EXPECT_EQ(component.flipped_edges, part.characteristics.flipped_edges);
  EXPECT_EQ(component.zero_area_faces, part.characteristics.zero_area_faces);
  EXPECT_EQ(component.closed, part.attributes.closed.value);
  EXPECT_EQ(component.manifold, part.attributes.manifold.value);
  EXPECT_EQ(component.orientable, part.attributes.orientable.value);
  EXPECT_EQ(component.consistent, part.attributes.consistent.value);
  EXPECT_EQ(component.outward, part.attributes.outward.value);
  EXPECT_EQ(component.genus, part.characteristics.genus.value);
  EXPECT_EQ(component.volume, part.characteristics.volume.value);
  EXPECT_EQ(component.area, part.characteristics.area);
  EXPECT_EQ(component.bounding_box.min(), part.characteristics.bounding_box.min());
  EXPECT_EQ(component.bounding_box.max(), part.characteristics.bounding_box.max());
  const ComponentStatistics& statistics = whole.component_statistics.at(i);
  for (std::size_t row = 0; row < kElementMeasures<Summary>.size(); ++row) {
    expect_same(statistics[row], part.characteristics[row]);
  }
}

TEST(SummarizeByComponent, ValuesGoToTheirComponentAndOthersNowhere) {
  const std::vector<double> values{1, 2, 30, 4, 50, 100};
  const std::vector<Index> component{0, 0, 2, 0, 2, kNoIndex};
  const std::vector<Summary> all =
      summarize_by_component(3, values, [&](std::size_t i) { return component[i]; });
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].count, 3U);
  EXPECT_EQ(all[0].median, 2.0);
  EXPECT_EQ(all[0].total, 7.0);
  EXPECT_EQ(all[1].count, 0U);
  EXPECT_EQ(all[2].min, 30.0);
  EXPECT_EQ(all[2].max, 50.0);
  // (30 - 40)^2 + (50 - 40)^2 over n - 1.
  EXPECT_EQ(all[2].variance, 200.0);
}

TEST(SummarizeByComponent, InfiniteValuesAreCountedApart) {
  const std::vector<double> values{1, std::numeric_limits<double>::infinity()};
  const std::vector<Summary> all =
      summarize_by_component(1, values, [](std::size_t) { return Index{0}; });
  EXPECT_EQ(all[0].count, 1U);
  EXPECT_EQ(all[0].infinite, 1U);
}

TEST(ComponentStatistics, OfEachComponentAreThoseOfItAlone) {
  // Far enough apart that none touches or encloses another.
  const std::vector<Soup> parts{
      shapes::torus(2, 0.5, 12, 8),
      shapes::translated(shapes::two_tetrahedra_sharing_edge(), {10, 0, 0}),
      shapes::translated(shapes::moebius_strip(9), {20, 0, 0}),
      shapes::translated(shapes::fan_of_three(), {30, 0, 0}),
      shapes::translated(shapes::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), {40, 0, 0}),
      shapes::translated(shapes::cube(), {50, 0, 0})};
  Soup soup;
  for (const Soup& part : parts) soup = shapes::merged(soup, part);
  const Analysis whole = analyze(soup, "whole");
  ASSERT_EQ(whole.components.size(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) expect_component(whole, i, parts[i]);
}

TEST(ComponentStatistics, LoneComponentHasThemInTheMesh) {
  EXPECT_TRUE(analyze(shapes::cube(), "cube").component_statistics.empty());
}

TEST(ComponentStatistics, ManyComponentsGoWithout) {
  Soup soup;
  for (std::size_t i = 0; i <= Analysis::kMaxComponentStatistics; ++i) {
    const double x = 2.0 * static_cast<double>(i);
    const auto first = static_cast<Index>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const Analysis analysis = analyze(soup, "many");
  EXPECT_EQ(analysis.components.size(), Analysis::kMaxComponentStatistics + 1);
  EXPECT_TRUE(analysis.component_statistics.empty());
  EXPECT_EQ(analysis.components.back().first_face, Analysis::kMaxComponentStatistics);
  EXPECT_NEAR(analysis.components.back().area, 0.5, 1e-15);
}

}  // namespace
}  // namespace meshalyzer
