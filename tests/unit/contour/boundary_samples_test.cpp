#include "meshalyzer/contour/boundary_samples.h"

#include "support/shapes.h"
#include "support/triangles_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace meshalyzer {
namespace {

Soup without_top(Soup cube, double height) {
  std::erase_if(cube.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) { return cube.positions[v][2] == height; });
  });
  return cube;
}

/// The samples of pieces that lie on the boundary of the solid that a mesh represents.
std::vector<Vec3> boundary_samples(const Soup& mesh, const std::vector<Corners>& pieces,
                                   double spacing) {
  const SolidBoundary boundary(mesh, 1e-3);
  std::vector<Vec3> points;
  for (const PieceSample& sample : sample_pieces(pieces, spacing)) {
    if (boundary.is_at(sample.point, pieces[sample.piece])) points.push_back(sample.point);
  }
  return points;
}

TEST(SamplePieces, LeavesNoGaps) {
  const double spacing = 0.1;
  const std::vector<Corners> faces = test::triangles_of(shapes::cube(2));
  const std::vector<PieceSample> samples = sample_pieces(faces, spacing);
  EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end(),
                             [](const auto& a, const auto& b) { return a.piece < b.piece; }));
  // On each face, a point of a grid has a sample no farther away than the spacing.
  for (Index face = 0; face < faces.size(); ++face) {
    const Corners& t = faces[face];
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; i + j <= 20; ++j) {
        const Vec3 point = t[0] + i / 20.0 * (t[1] - t[0]) + j / 20.0 * (t[2] - t[0]);
        EXPECT_TRUE(std::any_of(samples.begin(), samples.end(), [&](const PieceSample& s) {
          return s.piece == face && (s.point - point).norm() <= spacing;
        }));
      }
    }
  }
}

TEST(SamplePieces, EachWithAnAreaHasASample) {
  const Corners small{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const Corners flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  const std::vector<PieceSample> samples = sample_pieces(std::vector<Corners>{flat, small}, 100.0);
  ASSERT_EQ(samples.size(), 1U);
  EXPECT_EQ(samples.front().piece, 1U);
  EXPECT_TRUE(samples.front().point.isApprox(Vec3(1.0 / 3, 1.0 / 3, 0)));
  EXPECT_TRUE(sample_pieces({}, 1.0).empty());
}

TEST(SolidBoundary, IsAllOverAClosedSurfaceWhicheverWayItPoints) {
  // A bar of 2 x 1/8 x 1/8.
  Soup bar = shapes::cube(2);
  for (Vec3& p : bar.positions) p = p.cwiseProduct(Vec3(1, 1.0 / 16, 1.0 / 16));
  for (const Soup& soup : {bar, shapes::flipped(bar)}) {
    const std::vector<Corners> faces = test::triangles_of(soup);
    EXPECT_EQ(boundary_samples(soup, faces, 0.02).size(), sample_pieces(faces, 0.02).size());
  }
}

TEST(SolidBoundary, LeavesOutWallsInsideTheSolid) {
  const Soup inner = shapes::cube(1, {1, 1, 1});
  const Soup both = shapes::merged(shapes::cube(3), inner);
  EXPECT_TRUE(boundary_samples(both, test::triangles_of(inner), 0.05).empty());
}

TEST(SolidBoundary, LeavesOutWhatIsNearAHole) {
  // A wall that ends in the middle of the opening has winding numbers of about a half there.
  const Soup open = without_top(shapes::cube(2), 2);
  const Soup wall = shapes::make({{0.9, 0.9, 1.9}, {1.1, 0.9, 1.9}, {1, 1.1, 1.9}}, {{0, 1, 2}});
  EXPECT_FALSE(boundary_samples(open, test::triangles_of(open), 0.05).empty());
  EXPECT_TRUE(boundary_samples(open, test::triangles_of(wall), 0.05).empty());
}

}  // namespace
}  // namespace meshalyzer
