#include "meshalyzer/spatial/oriented_boxes.h"

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/triangle_distance.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace meshalyzer {
namespace {

/// A vector in the cube from -1 to 1.
Vec3 any_vector(std::mt19937& random) {
  const double x = uniform(random, -1, 1);
  const double y = uniform(random, -1, 1);
  return {x, y, uniform(random, -1, 1)};
}

/// The triangles of a tree as ClosestPoints keeps them.
std::vector<EightTriangles> triangles_by_leaf(const FaceTree& tree) {
  std::vector<EightTriangles> all(tree.n_leaves(), EightTriangles::none());
  for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<float, 3> p = tree.map(tree.point(tree.triangle(slot)[c]));
      for (std::size_t k = 0; k < 3; ++k) all[slot / 8].corners[c][k][slot % 8] = p[k];
    }
  }
  return all;
}

/// A mesh, its tree, and the oriented boxes of its first eight leaves.
struct BoxedLeaves {
  explicit BoxedLeaves(const Soup& soup) : cut(build(soup)) {}
  CutMesh cut;
  FaceTree tree{cut};
  std::vector<EightTriangles> triangles = triangles_by_leaf(tree);
  EightOrientedBoxes boxes = oriented_boxes_of(tree, triangles, 0);

  /// The distances that the boxes allow at least, in the tree's coordinates.
  [[nodiscard]] std::array<double, 8> bounds(const Vec3& point) const {
    std::array<double, 8> all;
    std::ranges::transform(squared_distances(boxes, tree.map(point)).numbers(), all.begin(),
                           [](float squared) { return std::sqrt(static_cast<double>(squared)); });
    return all;
  }
  /// The distance of a leaf in the tree's coordinates, by asking all of its faces.
  [[nodiscard]] double distance(std::size_t leaf, const Vec3& point) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t slot = 8 * leaf; slot < std::min(8 * leaf + 8, tree.n_faces()); ++slot) {
      const Triangle t = tree.triangle(slot);
      const Corners corners{tree.point(t[0]), tree.point(t[1]), tree.point(t[2])};
      least = std::min(least, closest_on_triangle(corners, point).distance * tree.scale());
    }
    return least;
  }
};

/// Adds what ClosestPoints allows for rounding (kAbsoluteSlack, kRelativeSlack).
double with_slack(double distance) {
  return distance * (1 + 0x1p-19) + 0x1p-18;
}

TEST(OrientedBoxes, NoLeafIsNearerThanItsBox) {
  std::mt19937 random(1);
  std::vector<Soup> soups{shapes::icosphere(3), shapes::torus(1, 0.3, 20, 12),
                          shapes::scaled(shapes::icosphere(2), 1e-9), shapes::cube(),
                          shapes::grid(7, 5)};
  // Faces of no area, which have no normal.
  soups.push_back(shapes::scaled(shapes::grid(7, 5), 1.0));
  for (Vec3& p : soups.back().positions) p.y() = p.x();
  soups.push_back(shapes::translated(shapes::icosphere(3), {1e6, -1e6, 3e5}));
  for (const Soup& soup : soups) {
    const BoxedLeaves scene(soup);
    const double size = scene.tree.bounds().diagonal().norm();
    const std::size_t n_leaves = std::min<std::size_t>(8, scene.tree.n_leaves());
    for (int i = 0; i < 400; ++i) {
      const double reach = i % 2 == 0 ? 0.05 : i % 3 == 0 ? 100.0 : 1.0;
      const Index corner =
          scene.tree.triangle(static_cast<std::size_t>(i) % scene.tree.n_faces())[0];
      const Vec3 point = scene.tree.point(corner) + reach * size * any_vector(random);
      const std::array<double, 8> bounds = scene.bounds(point);
      for (std::size_t leaf = 0; leaf < n_leaves; ++leaf) {
        EXPECT_LE(bounds[leaf], with_slack(scene.distance(leaf, point)));
      }
    }
  }
}

TEST(OrientedBoxes, BoxOfFlatFacesAskewIsFlat) {
  // The plane x + y + z = 0, to which all axes are equally askew.
  Soup soup = shapes::grid(10, 10);
  const Vec3 u = Vec3(1, -1, 0).normalized();
  const Vec3 v = Vec3(1, 1, -2).normalized();
  for (Vec3& p : soup.positions) p = (p.x() - 5) * u + (p.y() - 5) * v;
  const BoxedLeaves scene(soup);
  for (std::size_t leaf = 0; leaf < 8; ++leaf) {
    for (const double height : {-0.5, 0.001, 3.0}) {
      const Vec3 point = scene.tree.point(scene.tree.triangle(8 * leaf)[0]) +
                         height / std::sqrt(3.0) * Vec3::Ones();
      EXPECT_NEAR(scene.bounds(point)[leaf], std::abs(height) * scene.tree.scale(), 1e-6);
    }
  }
}

TEST(OrientedBoxes, BoxIsNearlyAsFarAsItsLeafIsFromFarAway) {
  std::mt19937 random(2);
  const BoxedLeaves scene(shapes::icosphere(3));
  for (int i = 0; i < 100; ++i) {
    const Vec3 point = 1000.0 * any_vector(random).normalized();
    const std::array<double, 8> bounds = scene.bounds(point);
    for (std::size_t leaf = 0; leaf < 8; ++leaf) {
      EXPECT_GT(bounds[leaf], 0.99 * scene.distance(leaf, point));
    }
  }
}

TEST(OrientedBoxes, LeavesThatAreNotThereAreFartherThanAnything) {
  const BoxedLeaves scene(shapes::cube());  // 12 faces, two leaves
  const std::array<double, 8> bounds = scene.bounds(Vec3::Zero());
  EXPECT_TRUE(std::isfinite(bounds[0]) && std::isfinite(bounds[1]));
  EXPECT_TRUE(std::isinf(bounds[2]) && std::isinf(bounds[7]));
}

TEST(OrientedBoxes, LeafWithAFarFaceMayBeAnywhere) {
  Soup soup = shapes::grid(40, 40);
  soup.positions.push_back(Vec3(1e9, 1e9, 1e9));
  soup.triangles.push_back({0, 1, static_cast<Index>(soup.positions.size() - 1)});
  const BoxedLeaves scene(soup);
  ASSERT_TRUE(scene.tree.has_far_faces());
  for (std::size_t first = 0; first < scene.tree.n_leaves(); first += 8) {
    const EightOrientedBoxes boxes = oriented_boxes_of(scene.tree, scene.triangles, first);
    const auto squared = squared_distances(boxes, {0.3F, -0.7F, 0.9F}).numbers();
    for (std::size_t i = 0; i < 8 && first + i < scene.tree.n_leaves(); ++i) {
      EXPECT_EQ(squared[i] == 0.0F, scene.tree.is_far_leaf(first + i));
    }
  }
}

}  // namespace
}  // namespace meshalyzer
