#include "meshalyzer/picture/internal/scene_lines.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

using Point = std::array<float, 3>;

/// Segments as sets of two points.
std::set<std::set<Point>> segments(const std::vector<float>& floats) {
  std::set<std::set<Point>> all;
  for (std::size_t i = 0; i + 6 <= floats.size(); i += 6) {
    const float* f = floats.data() + i;
    all.insert({Point{f[0], f[1], f[2]}, Point{f[3], f[4], f[5]}});
  }
  return all;
}

/// Nothing is moved or scaled.
DrawingFrame no_frame() {
  return DrawingFrame(Box3());
}

TEST(DrawLines, BorderOfASquareIsItsSides) {
  const Soup soup = shapes::grid(1, 1);
  const PreparedMesh mesh(soup);
  const DrawnLines drawn = draw_lines(mesh, no_frame(), 100);
  const Point a{0, 0, 0};
  const Point b{1, 0, 0};
  const Point c{1, 1, 0};
  const Point d{0, 1, 0};
  EXPECT_EQ(segments(drawn.lines.borders),
            (std::set<std::set<Point>>{{a, b}, {b, c}, {c, d}, {d, a}}));
  EXPECT_TRUE(drawn.lines.flipped_edges.empty());
  EXPECT_TRUE(drawn.lines.non_manifold_edges.empty());
  EXPECT_TRUE(drawn.lines.intersections.empty());
  EXPECT_TRUE(drawn.notes.empty());
}

TEST(DrawLines, CutEdgeIsDrawnOnce) {
  const Soup fan = shapes::fan_of_three();
  const PreparedMesh mesh(fan);
  EXPECT_EQ(draw_lines(mesh, no_frame(), 100).lines.non_manifold_edges.size(), 6U);
  const Soup turned = shapes::flipped(shapes::grid(1, 1), std::vector<Index>{1});
  const PreparedMesh turned_mesh(turned);
  EXPECT_EQ(draw_lines(turned_mesh, no_frame(), 100).lines.flipped_edges.size(), 6U);
}

TEST(DrawLines, CrossingFacesMeetInALine) {
  // Through the square above its diagonal, at y = 3/4 and from x = 0 to 1/2 at z = 0.
  Soup soup = shapes::grid(1, 1);
  const Soup blade =
      shapes::make({Vec3(0.25, 0.75, -1), Vec3(-0.25, 0.75, 1), Vec3(0.75, 0.75, 1)}, {{0, 1, 2}});
  soup = shapes::merged(soup, blade);
  const PreparedMesh mesh(soup);
  ASSERT_FALSE(mesh.intersecting_pairs().empty());
  const DrawnLines drawn = draw_lines(mesh, no_frame(), 100);
  float low = 9.0F;
  float high = -9.0F;
  for (std::size_t i = 0; i < drawn.lines.intersections.size(); i += 3) {
    low = std::min(low, drawn.lines.intersections[i]);
    high = std::max(high, drawn.lines.intersections[i]);
    EXPECT_NEAR(drawn.lines.intersections[i + 1], 0.75F, 1e-6F);
    EXPECT_NEAR(drawn.lines.intersections[i + 2], 0.0F, 1e-6F);
  }
  EXPECT_NEAR(low, 0.0F, 1e-6F);
  EXPECT_NEAR(high, 0.5F, 1e-6F);
}

TEST(DrawLines, TooManyAreCutAndSaidSo) {
  const Soup soup = shapes::grid(10, 10);
  const PreparedMesh mesh(soup);
  const DrawnLines drawn = draw_lines(mesh, no_frame(), 7);
  EXPECT_EQ(drawn.lines.borders.size(), 42U);
  EXPECT_EQ(drawn.notes,
            (std::vector<std::string>{"Of 40 border edges the first 7 are drawn as lines."}));
}

TEST(DrawLines, TooManyContactsAreCutAndSaidSo) {
  // Every two of these faces are duplicates: three pairs, with an outline of three lines each.
  const Soup soup = shapes::make({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                 {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}});
  const PreparedMesh mesh(soup);
  EXPECT_EQ(draw_lines(mesh, no_frame(), 9).lines.intersections.size(), 54U);
  const DrawnLines drawn = draw_lines(mesh, no_frame(), 8);
  EXPECT_EQ(drawn.lines.intersections.size(), 48U);
  EXPECT_EQ(drawn.notes,
            (std::vector<std::string>{
                "Of 3 intersecting pairs the first 8 lines along which they meet are drawn."}));
}

}  // namespace
}  // namespace meshalyzer
