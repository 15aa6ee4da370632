#include "meshalyzer/picture/scene.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

const std::vector<FieldName> kFields{FieldName::Area, FieldName::Valence, FieldName::Defect};

Scene scene_of(const Soup& soup, const SceneLimits& limits = {}) {
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh);
  return make_scene({mesh, &report}, kFields, limits);
}

/// Small enough for meshes of some thousand faces not to be drawn as they are.
constexpr SceneLimits kSmall{
    .max_whole_faces = 1000, .max_detail_faces = 400, .max_context_faces = 600};

/// Faces of a grid of 100 x 100 squares that are not at its border.
const std::vector<Index> kHoles{4500, 15080};

Soup grid_with_holes() {
  return shapes::without_faces(shapes::grid(100, 100), kHoles);
}

void expect_consistent(const DrawnSurface& surface) {
  EXPECT_EQ(surface.positions.size(), 3 * surface.n_vertices());
  EXPECT_EQ(surface.normals.size(), 3 * surface.n_vertices());
  EXPECT_EQ(surface.triangles.size(), 3 * surface.n_faces());
  for (const std::uint32_t v : surface.triangles) EXPECT_LT(v, surface.n_vertices());
  for (const std::vector<float>* floats : {&surface.positions, &surface.normals}) {
    for (const float x : *floats) EXPECT_TRUE(std::isfinite(x));
  }
}

TEST(MakeScene, EmptyMeshIsAnEmptyScene) {
  const Scene scene = scene_of(Soup{});
  EXPECT_EQ(scene.detail.n_faces(), 0U);
  EXPECT_EQ(scene.context.n_faces(), 0U);
  EXPECT_GT(scene.radius, 0.0);
  EXPECT_TRUE(scene.notes.empty());
}

TEST(MakeScene, SmallMeshIsDrawnAsItIs) {
  const Soup soup = shapes::translated(shapes::torus(3, 1, 12, 8), Vec3(100, 200, 300));
  const Scene scene = scene_of(soup);
  expect_consistent(scene.detail);
  ASSERT_EQ(scene.detail.n_faces(), soup.n_faces());
  EXPECT_EQ(scene.context.n_faces(), 0U);
  EXPECT_EQ(scene.n_faces, soup.n_faces());
  EXPECT_EQ(scene.n_decimated, 0U);
  EXPECT_TRUE(scene.notes.empty());
  EXPECT_TRUE(scene.highlights.empty());
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    EXPECT_EQ(scene.detail.faces[f], f);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = scene.detail.triangles[3 * f + k];
      EXPECT_EQ(scene.detail.vertices[v], soup.triangles[f][k]);
      const Vec3 wanted = soup.positions[soup.triangles[f][k]] - scene.centre;
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(scene.detail.positions[3 * v + i],
                  static_cast<float>(wanted[static_cast<Eigen::Index>(i)]));
      }
    }
  }
}

TEST(MakeScene, NormalsAreThoseOfTheVertices) {
  const Scene scene = scene_of(shapes::icosphere(2));
  // On a ball about the centre they point where the vertex is, but for the coarseness.
  for (std::size_t i = 0; i < scene.detail.normals.size(); ++i) {
    EXPECT_NEAR(scene.detail.normals[i], scene.detail.positions[i], 0.05F);
  }
}

TEST(MakeScene, PlacesComeBackFromDrawnCoordinatesAtAnySize) {
  for (const double size : {1e-300, 1e-9, 1.0, 1e9, 1e300}) {
    const Soup soup = shapes::scaled(shapes::cube(1.0, Vec3(1, 2, 3)), size);
    const Scene scene = scene_of(soup);
    expect_consistent(scene.detail);
    ASSERT_EQ(scene.detail.n_vertices(), 8U);
    for (std::size_t i = 0; i < 24; ++i) {
      const auto k = static_cast<Eigen::Index>(i % 3);
      const double place =
          static_cast<double>(scene.detail.positions[i]) / scene.scale + scene.centre[k];
      EXPECT_NEAR(place / size, soup.positions[scene.detail.vertices[i / 3]][k] / size, 1e-6);
    }
  }
}

TEST(MakeScene, FacesWithoutAllCornersAreLeftOutAndCounted) {
  Soup soup = shapes::cube();
  soup.triangles[3][0] = kNoIndex;
  soup.missing = {{3, 0, 99}};
  const Scene scene = scene_of(soup);
  EXPECT_EQ(scene.n_faces, 11U);
  EXPECT_EQ(scene.detail.n_faces(), 11U);
  EXPECT_EQ(std::count(scene.detail.faces.begin(), scene.detail.faces.end(), 3U), 0);
  ASSERT_FALSE(scene.notes.empty());
  EXPECT_EQ(scene.notes[0], "1 face is not drawn: corners have no place.");
}

TEST(MakeScene, FacesThatAreInNoComplexAreDrawn) {
  Soup soup = shapes::cube();
  soup.triangles.push_back({1, 1, 2});
  EXPECT_EQ(scene_of(soup).detail.n_faces(), 13U);
}

TEST(MakeScene, BigMeshWithoutDefectsIsDecimated) {
  const Soup soup = shapes::icosphere(5);
  const Scene scene = scene_of(soup, kSmall);
  expect_consistent(scene.context);
  EXPECT_EQ(scene.detail.n_faces(), 0U);
  EXPECT_EQ(scene.n_decimated, soup.n_faces());
  EXPECT_LE(scene.context.n_faces(), 600U);
  EXPECT_GE(scene.context.n_faces(), 300U);
  ASSERT_EQ(scene.notes.size(), 1U);
  EXPECT_NE(scene.notes[0].find("The mesh has 20,480 faces, drawn decimated to "),
            std::string::npos);
}

TEST(MakeScene, BigMeshShowsWhatIsRoundItsDefects) {
  const Soup soup = grid_with_holes();
  const Scene scene = scene_of(soup, kSmall);
  expect_consistent(scene.detail);
  expect_consistent(scene.context);
  EXPECT_EQ(scene.detail.n_faces(), 400U);
  EXPECT_EQ(scene.n_decimated, soup.n_faces() - 400);
  const std::set<Index> detail(scene.detail.faces.begin(), scene.detail.faces.end());
  for (const Index f : scene.context.faces) EXPECT_FALSE(detail.contains(f));
  std::set<Index> corners;
  for (const Index hole : kHoles) {
    const Triangle t = shapes::grid(100, 100).triangles[hole];
    corners.insert(t.begin(), t.end());
  }
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (std::any_of(t.begin(), t.end(), [&](Index v) { return corners.contains(v); })) {
      EXPECT_TRUE(detail.contains(f)) << f;
    }
  }
  ASSERT_FALSE(scene.notes.empty());
  EXPECT_EQ(scene.notes[0].rfind("The mesh has 19,998 faces; the 400 nearest to the defects are "
                                 "drawn as they are, the other 19,598 decimated to ",
                                 0),
            0U);
}

TEST(MakeScene, NoGapOpensBesideWhatIsShownInDetail) {
  const Soup soup = grid_with_holes();
  const Scene scene = scene_of(soup, kSmall);
  const std::set<Index> detail(scene.detail.faces.begin(), scene.detail.faces.end());
  const std::set<Index> inside(scene.detail.vertices.begin(), scene.detail.vertices.end());
  const std::set<Index> outside(scene.context.vertices.begin(), scene.context.vertices.end());
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (detail.contains(f)) continue;
    for (const Index v : soup.triangles[f]) {
      EXPECT_TRUE(!inside.contains(v) || outside.contains(v)) << v;
    }
  }
}

TEST(MakeScene, FieldsHaveAValueForAllThatIsDrawn) {
  const Soup soup = grid_with_holes();
  const Scene scene = scene_of(soup, kSmall);
  ASSERT_EQ(scene.fields.size(), 3U);
  const DrawnField& area = scene.fields[0];
  // Half squares of side 1.
  EXPECT_EQ(area.detail, std::vector<float>(scene.detail.n_faces(), 0.5F));
  EXPECT_EQ(area.context, std::vector<float>(scene.context.n_faces(), 0.5F));
  EXPECT_EQ(area.min, 0.5);
  EXPECT_EQ(area.max, 0.5);
  const DrawnField& valence = scene.fields[1];
  ASSERT_EQ(valence.detail.size(), scene.detail.n_vertices());
  ASSERT_EQ(valence.context.size(), scene.context.n_vertices());
  // In a corner of the grid 2, inside 6, and a corner of a hole has lost nothing.
  EXPECT_EQ(valence.min, 2.0);
  EXPECT_EQ(valence.max, 6.0);
  for (std::size_t i = 0; i < scene.context.n_vertices(); ++i) {
    const Index x = scene.context.vertices[i] % 101;
    const Index y = scene.context.vertices[i] / 101;
    if (x > 0 && x < 100 && y > 0 && y < 100) {
      EXPECT_EQ(valence.context[i], 6.0F);
    }
  }
}

TEST(MakeScene, DefectsThatAreNotLitAreCounted) {
  Soup soup = shapes::cube();
  for (int i = 0; i < 9; ++i) soup.positions.emplace_back(i, 5, 5);
  const Scene scene = scene_of(soup, {.max_defects_of_a_code = 4});
  EXPECT_EQ(scene.highlights.size(), 4U);
  EXPECT_EQ(
      scene.notes,
      (std::vector<std::string>{"Of 9 defects of code orphan-vertex the first 4 can be lit up."}));
}

TEST(MakeScene, DefectsThatAreLitInPartAreCounted) {
  // A border of 40 edges.
  const Scene scene = scene_of(shapes::grid(10, 10), {.max_elements_of_a_defect = 12});
  ASSERT_EQ(scene.highlights.size(), 1U);
  EXPECT_EQ(scene.notes, (std::vector<std::string>{"Of 1 defect only a part is lit up."}));
}

TEST(MakeScene, WhatIsLitOfABigMeshTakesHalfOfTheDetail) {
  // The border of 400 edges takes more than the limit of all elements allows: half of 400 faces.
  const Scene scene = scene_of(shapes::grid(100, 100), kSmall);
  ASSERT_EQ(scene.highlights.size(), 1U);
  EXPECT_EQ(scene.highlights[0].segments.size(), 200 * 6U);
  EXPECT_TRUE(scene.highlights[0].is_cut);
}

TEST(MakeScene, ValuesBeyondSinglePrecisionStayFinite) {
  // Areas of 1e200 / 2.
  const Scene scene = scene_of(shapes::scaled(shapes::grid(1, 1), 1e100));
  for (const float area : scene.fields[0].detail)
    EXPECT_EQ(area, std::numeric_limits<float>::max());
  EXPECT_GT(scene.fields[0].max, 1e199);
}

TEST(MakeScene, MeshWithAPositionThatIsNotFiniteIsRefused) {
  Soup soup = shapes::cube();
  soup.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  const PreparedMesh mesh(soup);
  EXPECT_THROW(static_cast<void>(make_scene({mesh}, {})), InvalidArgument);
}

TEST(MakeScene, WithoutAReportNothingIsLit) {
  const Soup soup = shapes::open_cube();
  const PreparedMesh mesh(soup);
  const Scene scene = make_scene({mesh}, {});
  EXPECT_TRUE(scene.highlights.empty());
  EXPECT_EQ(scene.lines.borders.size(), 4 * 6U);
}

TEST(MakeScene, HighlightsOfABigMeshAreInDetail) {
  std::mt19937 random(1);
  const Soup soup = damaged(shapes::grid(100, 100), 500, random);
  const Scene scene = scene_of(soup, kSmall);
  ASSERT_FALSE(scene.highlights.empty());
  for (const Highlight& highlight : scene.highlights) {
    EXPECT_GT(highlight.radius, 0.0F);
    for (const std::uint32_t f : highlight.faces) EXPECT_LT(f, scene.detail.n_faces());
    EXPECT_FALSE(highlight.faces.empty() && highlight.segments.empty() && highlight.points.empty());
  }
}

TEST(MakeScene, NumberOfThreadsDoesNotMatter) {
  std::mt19937 random(2);
  const Soup soup = damaged(shapes::torus(3, 1, 150, 100), 300, random);
  const Scene wanted = scene_of(soup, kSmall);
  const ThreadLimit one(1);
  const Scene found = scene_of(soup, kSmall);
  EXPECT_EQ(found.detail.faces, wanted.detail.faces);
  EXPECT_EQ(found.detail.normals, wanted.detail.normals);
  EXPECT_EQ(found.context.triangles, wanted.context.triangles);
  EXPECT_EQ(found.context.positions, wanted.context.positions);
  EXPECT_EQ(found.lines.intersections, wanted.lines.intersections);
  EXPECT_EQ(found.notes, wanted.notes);
  ASSERT_EQ(found.highlights.size(), wanted.highlights.size());
  for (std::size_t i = 0; i < found.highlights.size(); ++i) {
    EXPECT_EQ(found.highlights[i].faces, wanted.highlights[i].faces);
    EXPECT_EQ(found.highlights[i].segments, wanted.highlights[i].segments);
    EXPECT_EQ(found.highlights[i].radius, wanted.highlights[i].radius);
  }
}

}  // namespace
}  // namespace meshalyzer
