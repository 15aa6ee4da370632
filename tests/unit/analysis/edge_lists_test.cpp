#include "meshalyzer/analysis/internal/edge_lists.h"

#include "meshalyzer/analysis/analyze.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <vector>

namespace meshalyzer {
namespace {

using Ends = std::vector<std::array<Index, 2>>;
using Faces = std::vector<Index>;

Offenders offenders(const Soup& soup, const AnalysisOptions& options = {}) {
  return analyze(soup, "soup", options).offenders;
}

/// The faces at one edge of a list.
Faces faces_at(const EdgeList& list, std::size_t edge) {
  return {list.faces.begin() + list.begin[edge], list.faces.begin() + list.begin[edge + 1]};
}

TEST(EdgeLists, NothingIsNamedThatWasNotAskedFor) {
  const Offenders named = offenders(shapes::cube());
  EXPECT_FALSE(named.short_edges.has_value());
  EXPECT_FALSE(named.long_edges.has_value());
  EXPECT_FALSE(named.small_angles.has_value());
  EXPECT_FALSE(named.large_angles.has_value());
  EXPECT_FALSE(named.large_aspect_ratios.has_value());
}

TEST(EdgeLists, ShortAndLongEdgesPartTheCube) {
  AnalysisOptions options;
  options.shorter_than = 1.2;
  options.longer_than = 1.2;
  const Offenders named = offenders(shapes::cube(), options);
  // 12 edges of length 1, 6 diagonals of sqrt 2.
  EXPECT_EQ(named.short_edges->values, std::vector<double>(12, 1.0));
  ASSERT_EQ(named.long_edges->size(), 6U);
  for (const double length : named.long_edges->values) {
    EXPECT_NEAR(length, std::numbers::sqrt2, 1e-15);
  }
  // From the first to the third corner of each quad of cube(); the first quad is faces 0 and 1.
  EXPECT_EQ(named.long_edges->ends, (Ends{{0, 3}, {0, 5}, {1, 7}, {2, 4}, {3, 6}, {4, 7}}));
  EXPECT_EQ(faces_at(*named.long_edges, 0), (Faces{0, 1}));
}

TEST(EdgeLists, LengthAtTheLimitIsNeitherShortNorLong) {
  AnalysisOptions options;
  options.shorter_than = 1.0;
  options.longer_than = 1.5;
  const Offenders named = offenders(shapes::cube(), options);
  EXPECT_EQ(named.short_edges->size(), 0U);
  EXPECT_EQ(named.long_edges->size(), 0U);
  options.longer_than = 1.0;
  EXPECT_EQ(offenders(shapes::cube(), options).long_edges->size(), 6U);
}

TEST(EdgeLists, SmallAndLargeAnglesPartTheCube) {
  AnalysisOptions options;
  options.angle_below_degrees = 200;
  options.angle_above_degrees = 200;
  const Offenders named = offenders(shapes::cube(), options);
  EXPECT_EQ(named.small_angles->values, std::vector<double>(6, 180.0));
  EXPECT_EQ(named.large_angles->size(), 12U);
  for (const double angle : named.large_angles->values) EXPECT_NEAR(angle, 270.0, 1e-12);
  EXPECT_EQ(named.small_angles->ends, (Ends{{0, 3}, {0, 5}, {1, 7}, {2, 4}, {3, 6}, {4, 7}}));
}

TEST(EdgeLists, AngleAtTheLimitIsNeitherSmallNorLarge) {
  AnalysisOptions options;
  options.angle_below_degrees = 180;
  options.angle_above_degrees = 180;
  const Offenders named = offenders(shapes::grid(3, 3), options);
  EXPECT_EQ(named.small_angles->size(), 0U);
  EXPECT_EQ(named.large_angles->size(), 0U);
}

TEST(EdgeLists, FacesAboveAnAspectRatioAreNamedByTheirRecords) {
  // Face 0 is degenerate and in no mesh, face 2 is a needle: (1 + 0.1^2) / 0.1 = 10.1.
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -0.1, 0}},
                                 {{0, 0, 1}, {0, 1, 2}, {0, 3, 1}});
  AnalysisOptions options;
  options.aspect_above = 5;
  const Offenders named = offenders(soup, options);
  EXPECT_EQ(named.large_aspect_ratios->faces, Faces{2});
  EXPECT_NEAR(named.large_aspect_ratios->values.at(0), 10.1, 1e-12);
}

TEST(EdgeLists, ZeroAreaFaceIsAboveAnyAspectRatio) {
  AnalysisOptions options;
  options.aspect_above = 1e300;
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  EXPECT_EQ(offenders(soup, options).large_aspect_ratios->faces, Faces{0});
}

TEST(EdgeLists, BorderEdgesHaveTheirOneFace) {
  // The top of the open cube: vertices 4, 5, 6, 7.
  const EdgeList border = offenders(shapes::open_cube()).border_edges;
  EXPECT_EQ(border.ends, (Ends{{4, 5}, {4, 6}, {5, 7}, {6, 7}}));
  for (std::size_t i = 0; i < border.size(); ++i) EXPECT_EQ(faces_at(border, i).size(), 1U);
}

TEST(EdgeLists, NonManifoldEdgeHasAllItsFaces) {
  const EdgeList edges = offenders(shapes::two_tetrahedra_sharing_edge()).non_manifold_edges;
  EXPECT_EQ(edges.ends, (Ends{{0, 3}}));
  // The faces that name both 0 and 3 in shapes.cpp.
  EXPECT_EQ(faces_at(edges, 0), (Faces{1, 2, 5, 6}));
}

TEST(EdgeLists, ShortEdgeThatIsNonManifoldHasAllItsFacesToo) {
  AnalysisOptions options;
  options.shorter_than = 1.1;
  const EdgeList edges = *offenders(shapes::fan_of_three(), options).short_edges;
  // The common edge, and the one from 0 to the corner at distance 1; all others are sqrt 2 and
  // more.
  EXPECT_EQ(edges.ends, (Ends{{0, 1}, {0, 2}}));
  EXPECT_EQ(faces_at(edges, 0), (Faces{0, 1, 2}));
  EXPECT_EQ(faces_at(edges, 1), Faces{0});
}

TEST(EdgeLists, TurnedFaceHasThreeFlippedEdges) {
  const std::vector<Index> turned{0};
  const EdgeList edges = offenders(shapes::flipped(shapes::cube(), turned)).flipped_edges;
  // Face 0 of cube() is 0, 2, 3.
  EXPECT_EQ(edges.ends, (Ends{{0, 2}, {0, 3}, {2, 3}}));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ(faces_at(edges, i).size(), 2U);
    EXPECT_EQ(faces_at(edges, i).front(), 0U);
  }
}

TEST(EdgeLists, EdgeBetweenVerticesAtOnePlaceIsNamed) {
  const Soup soup =
      shapes::make({{0, 0, 0}, {1, 0, 0}, {1, 0, 1e-11}, {0, 1, 0}}, {{0, 1, 3}, {1, 2, 3}});
  const Offenders tolerant = offenders(soup);
  EXPECT_EQ(tolerant.indistinguishable_vertices, (Faces{1, 2}));
  EXPECT_EQ(tolerant.indistinguishable_edges.ends, (Ends{{1, 2}}));
  AnalysisOptions exact;
  exact.exact_coincidence = true;
  EXPECT_TRUE(offenders(soup, exact).indistinguishable_vertices.empty());
  EXPECT_EQ(offenders(soup, exact).indistinguishable_edges.size(), 0U);
}

TEST(EdgeLists, NamesAreFileRecordsWhateverTheOrder) {
  // The same edges by place, whichever way vertices are numbered.
  AnalysisOptions options;
  options.longer_than = 1.2;
  const std::vector<Index> place = shapes::permutation(8, 5);
  const EdgeList before = *offenders(shapes::cube(), options).long_edges;
  const EdgeList after =
      *offenders(shapes::renumbered_vertices(shapes::cube(), 5), options).long_edges;
  Ends expected;
  for (const auto& [a, b] : before.ends) {
    expected.push_back({std::min(place[a], place[b]), std::max(place[a], place[b])});
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(after.ends, expected);
}

}  // namespace
}  // namespace meshalyzer
