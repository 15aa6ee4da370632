#include "meshalyzer/picture/scene.h"

#include "soups_to_try.h"
#include "support/effort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

/// So that the smallest soups are decimated and cut too.
constexpr SceneLimits kTiny{.max_whole_faces = 12,
                            .max_detail_faces = 8,
                            .max_context_faces = 8,
                            .max_defects_of_a_code = 2,
                            .max_elements_of_a_defect = 3,
                            .max_elements_of_all = 10,
                            .max_segments = 4};

void expect_finite(const std::vector<float>& numbers) {
  EXPECT_TRUE(
      std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::isfinite(x); }));
}

/// Every vertex is used, and each array is as long as it must be.
void expect_whole(const DrawnSurface& surface, const Soup& soup) {
  ASSERT_EQ(surface.positions.size(), 3 * surface.n_vertices());
  ASSERT_EQ(surface.normals.size(), 3 * surface.n_vertices());
  ASSERT_EQ(surface.triangles.size(), 3 * surface.n_faces());
  const std::set<std::uint32_t> used(surface.triangles.begin(), surface.triangles.end());
  EXPECT_EQ(used.size(), surface.n_vertices());
  EXPECT_TRUE(used.empty() || *used.rbegin() < surface.n_vertices());
  for (const Index v : surface.vertices) EXPECT_LT(v, soup.n_vertices());
  for (const Index f : surface.faces) EXPECT_LT(f, soup.n_faces());
  expect_finite(surface.positions);
  expect_finite(surface.normals);
}

void expect_fields(const Scene& scene) {
  ASSERT_EQ(scene.fields.size() + 1, computed_field_names().size());  // no separation
  for (const DrawnField& field : scene.fields) {
    const bool is_of_faces = field.place == FieldPlace::Faces;
    const auto n_of = [&](const DrawnSurface& surface) {
      return is_of_faces ? surface.n_faces() : surface.n_vertices();
    };
    EXPECT_EQ(field.detail.size(), n_of(scene.detail));
    EXPECT_EQ(field.context.size(), n_of(scene.context));
    EXPECT_TRUE(std::isfinite(field.min) && std::isfinite(field.max));
    EXPECT_TRUE(std::isfinite(field.scale.min) && std::isfinite(field.scale.max));
    EXPECT_LE(field.scale.min, field.scale.max);
    EXPECT_LE(field.min, field.max);
  }
}

void expect_highlights(const Scene& scene, const DefectReport& report, const SceneLimits& limits) {
  std::size_t last = 0;
  for (const Highlight& highlight : scene.highlights) {
    EXPECT_TRUE(&highlight == &scene.highlights.front() || highlight.number > last);
    last = highlight.number;
    ASSERT_LT(highlight.number, report.defects.size());
    for (const std::uint32_t f : highlight.faces) EXPECT_LT(f, scene.detail.n_faces());
    EXPECT_LE(highlight.faces.size(), limits.max_elements_of_a_defect);
    expect_finite(highlight.segments);
    expect_finite(highlight.points);
    expect_finite({highlight.focus.begin(), highlight.focus.end()});
    EXPECT_TRUE(std::isfinite(highlight.radius));
    EXPECT_GT(highlight.radius, 0.0F);
  }
}

void expect_lines(const SceneLines& lines, const SceneLimits& limits) {
  for (const std::vector<float>* segments :
       {&lines.borders, &lines.non_manifold_edges, &lines.flipped_edges, &lines.intersections}) {
    EXPECT_EQ(segments->size() % 6, 0U);
    EXPECT_LE(segments->size(), 6 * limits.max_segments);
    expect_finite(*segments);
  }
}

void expect_scene(const PreparedMesh& mesh, const DefectReport& report, const SceneLimits& limits) {
  const Scene scene = make_scene({mesh, &report}, computed_field_names(), limits);
  expect_whole(scene.detail, mesh.soup());
  expect_whole(scene.context, mesh.soup());
  expect_fields(scene);
  expect_highlights(scene, report, limits);
  expect_lines(scene.lines, limits);
  EXPECT_GT(scene.radius, 0.0);
  if (scene.n_faces <= limits.max_whole_faces) {
    EXPECT_EQ(scene.detail.n_faces(), scene.n_faces);
  } else {
    EXPECT_LE(scene.detail.n_faces(), limits.max_detail_faces);
    EXPECT_LE(scene.context.n_faces(), limits.max_context_faces);
    EXPECT_EQ(scene.n_decimated, scene.n_faces - scene.detail.n_faces());
  }
}

void expect_scenes(const Soup& soup) {
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh);
  expect_scene(mesh, report, {});
  expect_scene(mesh, report, kTiny);
}

TEST(SceneLaw, EverySoupCanBeDrawnWithinTheLimits) {
  test::Effort effort;
  for (const NamedSoup& each : soups_to_try()) {
    if (!effort.runs_next()) continue;
    SCOPED_TRACE(each.name);
    expect_scenes(each.soup);
  }
}

TEST(SceneLaw, EverySoupCanBeDrawnAtExtremeSizes) {
  constexpr std::size_t kStep = 9;
  for (std::size_t i = 0; i < soups_to_try().size(); i += kStep * test::one_of()) {
    SCOPED_TRACE(soups_to_try()[i].name);
    for (const double size : {1e-320, 1e-200, 1e150, 1e305}) {
      Soup soup = soups_to_try()[i].soup;
      for (Vec3& p : soup.positions) p = (p * size).cwiseMax(-1e307).cwiseMin(1e307);
      SCOPED_TRACE(size);
      expect_scenes(soup);
    }
  }
}

}  // namespace
}  // namespace meshalyzer
