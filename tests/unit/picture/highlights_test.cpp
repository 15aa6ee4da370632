#include "meshalyzer/picture/internal/highlights.h"

#include "meshalyzer/picture/internal/drawn_surface.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace meshalyzer {
namespace {

/// The highlights of a mesh all of whose faces, or those given, are in detail.
std::vector<Highlight> highlights_of(const Soup& soup, const DefectOptions& options = {},
                                     const std::optional<std::vector<Index>>& in_detail = {},
                                     const SceneLimits& limits = {}) {
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh, options);
  const HighlightedDefects highlighted(mesh, report, limits);
  const std::vector<Index> faces = drawable_faces(soup);
  const DrawingFrame frame(box_of(soup, faces));
  const EdgeLengths lengths(soup, frame, faces);
  const std::vector<Vec3> normals(soup.n_vertices(), Vec3::Zero());
  const DrawnSurface detail =
      draw_surface(soup, frame, triangles_of(soup, in_detail.value_or(faces)), normals);
  return make_highlights({soup, frame, lengths, detail}, highlighted.all());
}

/// The largest distance from the focus of what is lit up.
double reach(const Highlight& highlight) {
  double reach = 0.0;
  for (const std::vector<float>* floats : {&highlight.segments, &highlight.points}) {
    for (std::size_t i = 0; i < floats->size(); ++i) {
      const auto offset = static_cast<double>((*floats)[i] - highlight.focus[i % 3]);
      reach = std::max(reach, std::abs(offset));
    }
  }
  return reach;
}

TEST(MakeHighlights, HoleIsItsBorder) {
  const std::vector<Highlight> highlights = highlights_of(shapes::open_cube());
  ASSERT_EQ(highlights.size(), 1U);
  EXPECT_TRUE(highlights[0].faces.empty());
  EXPECT_EQ(highlights[0].segments.size(), 4 * 6U);
  EXPECT_TRUE(highlights[0].points.empty());
  // The middle of the top, about the centre of the cube.
  EXPECT_EQ(highlights[0].focus, (std::array<float, 3>{0.0F, 0.0F, 0.5F}));
  EXPECT_GT(static_cast<double>(highlights[0].radius), reach(highlights[0]));
  EXPECT_FALSE(highlights[0].is_cut);
}

TEST(MakeHighlights, OrphanIsAPointWithItsSurroundings) {
  Soup soup = shapes::grid(20, 20);
  soup.positions.emplace_back(11, 12, 0);
  const std::vector<Highlight> highlights =
      highlights_of(soup, {.codes = {DefectCode::OrphanVertex}});
  ASSERT_EQ(highlights.size(), 1U);
  // About the middle (10, 10, 0).
  EXPECT_EQ(highlights[0].points, (std::vector<float>{1, 2, 0}));
  EXPECT_EQ(highlights[0].focus, (std::array<float, 3>{1, 2, 0}));
  // Some edges, which are 1 to sqrt(2) long, but not the whole.
  EXPECT_GT(highlights[0].radius, 2.0F);
  EXPECT_LT(highlights[0].radius, 6.0F);
}

TEST(MakeHighlights, FarOrphanLeavesNumbersFinite) {
  Soup soup = shapes::cube();
  soup.positions.emplace_back(1e308, -1e308, 0);
  const std::vector<Highlight> highlights =
      highlights_of(soup, {.codes = {DefectCode::OrphanVertex}});
  ASSERT_EQ(highlights.size(), 1U);
  for (const float x : highlights[0].points) EXPECT_TRUE(std::isfinite(x));
  for (const float x : highlights[0].focus) EXPECT_TRUE(std::isfinite(x));
  EXPECT_TRUE(std::isfinite(highlights[0].radius));
  EXPECT_GT(highlights[0].radius, 0.0F);
}

TEST(MakeHighlights, ViewOfAFarOrphanIsWideEnoughForSinglePrecision) {
  // About (1/2, 1/2, 1/2); near 1e7 floats are 1 apart, and the edges of the cube as long.
  Soup soup = shapes::cube();
  soup.positions.emplace_back(1e7, 0.5, 0.5);
  const std::vector<Highlight> highlights =
      highlights_of(soup, {.codes = {DefectCode::OrphanVertex}});
  ASSERT_EQ(highlights.size(), 1U);
  EXPECT_NEAR(highlights[0].radius, 100.0F, 1.0F);
}

TEST(MakeHighlights, ViewIsAsWideAsTheEdgesThereAreLong) {
  // A row of squares of side 8, and at its end a tiny square without neighbours, with a hole of its
  // own: four borders of 1/8, of which the mean of all edges, above 7, says nothing.
  Soup row = shapes::scaled(shapes::grid(20, 1), 8.0);
  const Soup tiny = shapes::translated(shapes::scaled(shapes::grid(1, 1), 0.125), Vec3(200, 0, 0));
  const std::vector<Highlight> highlights =
      highlights_of(shapes::merged(row, tiny), {.codes = {DefectCode::Hole}});
  ASSERT_EQ(highlights.size(), 2U);
  // Half the diagonal of 0.125 sqrt(2) is 0.09; three edges of 0.125 ... 0.18 are 0.375 ... 0.53.
  EXPECT_GT(highlights[1].radius, 0.09F + 0.375F);
  EXPECT_LT(highlights[1].radius, 0.09F + 0.54F);
}

TEST(MakeHighlights, SelfIntersectionIsItsFacesAndWhereTheyMeet) {
  // Two squares that cross at right angles along y = 1/2 ... of which each half square has a part.
  Soup soup = shapes::grid(1, 1);
  const Soup upright =
      shapes::make({Vec3(0.25, 0.5, -1), Vec3(0.25, 0.5, 1), Vec3(0.75, 0.5, 1)}, {{0, 1, 2}});
  soup = shapes::merged(soup, upright);
  const std::vector<Highlight> highlights =
      highlights_of(soup, {.codes = {DefectCode::SelfIntersection}});
  ASSERT_EQ(highlights.size(), 1U);
  const Highlight& found = highlights[0];
  EXPECT_GE(found.faces.size(), 2U);
  ASSERT_GE(found.segments.size(), 6U);
  for (std::size_t i = 0; i < found.segments.size(); i += 3) {
    // About the middle (1/2, 1/2, 0).
    EXPECT_NEAR(found.segments[i + 1], 0.0F, 1e-6F);
    EXPECT_NEAR(found.segments[i + 2], 0.0F, 1e-6F);
  }
}

TEST(MakeHighlights, TouchInAPointIsAPoint) {
  Soup soup = shapes::grid(1, 1);
  const Soup tip =
      shapes::make({Vec3(0.75, 0.25, 0), Vec3(0.5, 0.25, 1), Vec3(0.75, 0, 1)}, {{0, 1, 2}});
  soup = shapes::merged(soup, tip);
  const std::vector<Highlight> highlights =
      highlights_of(soup, {.codes = {DefectCode::SelfIntersection}});
  ASSERT_EQ(highlights.size(), 1U);
  EXPECT_TRUE(highlights[0].segments.empty());
  ASSERT_EQ(highlights[0].points.size(), 3U);
  // About the middle (1/2, 1/2, 1/2).
  EXPECT_NEAR(highlights[0].points[0], 0.25F, 1e-6F);
  EXPECT_NEAR(highlights[0].points[1], -0.25F, 1e-6F);
  EXPECT_NEAR(highlights[0].points[2], -0.5F, 1e-6F);
}

TEST(MakeHighlights, FlatFacetHasAnOutlineAndAPoint) {
  const Soup soup = shapes::make({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 1, 0)},
                                 {{0, 1, 2}, {0, 2, 3}});
  const std::vector<Highlight> highlights = highlights_of(soup, {.codes = {DefectCode::FlatFacet}});
  ASSERT_EQ(highlights.size(), 1U);
  EXPECT_EQ(highlights[0].faces, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(highlights[0].segments.size(), 3 * 6U);
  EXPECT_EQ(highlights[0].points.size(), 3U);
}

TEST(MakeHighlights, FacesAreThoseOfTheDetail) {
  // One of two duplicates is drawn, as the second face of the detail.
  Soup soup = shapes::grid(2, 1);
  soup.triangles.push_back(soup.triangles[2]);
  const std::vector<Highlight> highlights =
      highlights_of(soup, {.codes = {DefectCode::DuplicateFacet}}, std::vector<Index>{1, 2, 3});
  ASSERT_EQ(highlights.size(), 1U);
  EXPECT_EQ(highlights[0].faces, (std::vector<std::uint32_t>{1}));
  EXPECT_TRUE(highlights[0].is_cut);
}

TEST(MakeHighlights, WhatHasNoPlaceShowsTheWhole) {
  Soup soup = shapes::cube();
  soup.torn_lines = {7};
  const std::vector<Highlight> highlights = highlights_of(soup);
  ASSERT_EQ(highlights.size(), 1U);
  EXPECT_TRUE(highlights[0].points.empty());
  EXPECT_EQ(highlights[0].focus, (std::array<float, 3>{0, 0, 0}));
  EXPECT_NEAR(highlights[0].radius, std::sqrt(3.0F) / 2, 1e-6F);
}

TEST(MakeHighlights, FaceWithoutACornerIsShownByTheCornersThatThereAre) {
  Soup soup = shapes::cube();
  soup.triangles[3][0] = kNoIndex;
  soup.missing = {{3, 0, 99}};
  const std::vector<Highlight> highlights = highlights_of(soup, {.codes = {DefectCode::Corrupt}});
  ASSERT_EQ(highlights.size(), 1U);
  EXPECT_TRUE(highlights[0].faces.empty());
  EXPECT_EQ(highlights[0].points.size(), 3U);
  EXPECT_TRUE(highlights[0].is_cut);
}

TEST(MakeHighlights, LongBorderIsCut) {
  const std::vector<Highlight> highlights =
      highlights_of(shapes::grid(10, 10), {}, std::nullopt, {.max_elements_of_a_defect = 12});
  ASSERT_EQ(highlights.size(), 1U);
  EXPECT_EQ(highlights[0].segments.size(), 12 * 6U);
  EXPECT_TRUE(highlights[0].is_cut);
}

}  // namespace
}  // namespace meshalyzer
