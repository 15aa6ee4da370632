#include "meshalyzer/spatial/long_face_tree.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/contact_in_mesh.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "support/shapes.h"
#include "unit/spatial/pairs_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using Random = std::mt19937;
using LongVec3 = Eigen::Matrix<long double, 3, 1>;

/// Perpendicular axes of length 7, oblique to those of the file.
const std::vector<Vec3> kOblique{{2, 3, 6}, {3, -6, 2}, {6, 2, -3}};

/// Returns faces with integer coordinates, thin and 35 to 105 long, that run along the directions
/// in turn, all near the origin, so that many touch, cross or overlap.
Soup bundles(std::size_t n_faces, const std::vector<Vec3>& directions, unsigned seed) {
  Random random(seed);
  const auto integer = [&](int low, int high) {
    return static_cast<double>(std::uniform_int_distribution<int>(low, high)(random));
  };
  const auto near = [&] { return Vec3(integer(-1, 1), integer(-1, 1), integer(-1, 1)); };
  Soup soup;
  for (std::size_t i = 0; i < n_faces; ++i) {
    const Vec3& along = directions[i % directions.size()];
    const Vec3 begin = integer(-20, 20) * along + near();
    const double length = integer(5, 15);
    const auto first = static_cast<Index>(soup.n_vertices());
    for (const double part : {0.0, length, integer(1, 4)}) {
      soup.positions.emplace_back(begin + part * along + near());
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// Returns the pairs of a mesh by testing each face with each.
Pairs each_with_each(const CutMesh& cut, const FaceTree& tree) {
  Pairs pairs;
  for (std::size_t a = 0; a < tree.n_faces(); ++a) {
    for (std::size_t b = a + 1; b < tree.n_faces(); ++b) {
      const auto kind = find_contact_in_mesh(tree, tree.triangle(a), tree.triangle(b));
      if (!kind) continue;
      const auto [f, g] =
          std::minmax(cut.side.faces[tree.mesh_face(a)], cut.side.faces[tree.mesh_face(b)]);
      pairs.push_back({.face_a = f, .face_b = g, .kind = *kind});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const auto& p, const auto& q) {
    return std::pair(p.face_a, p.face_b) < std::pair(q.face_a, q.face_b);
  });
  return pairs;
}

void expect_pairs_of_each_with_each(const Soup& soup) {
  const CutMesh cut = build(soup);
  const FaceTree tree(cut);
  ASSERT_TRUE(turned_for_long_faces(tree));
  const Pairs pairs = each_with_each(cut, tree);
  EXPECT_GT(pairs.size(), 500U);
  EXPECT_EQ(listed(find_self_intersections(cut, tree)), listed(pairs));
}

TEST(TurnedForLongFaces, BundleAlongOneDirectionHasThePairsOfEachWithEach) {
  expect_pairs_of_each_with_each(bundles(560, {kOblique[0]}, 1));
}

TEST(TurnedForLongFaces, BundlesAlongThreeDirectionsHaveThePairsOfEachWithEach) {
  expect_pairs_of_each_with_each(bundles(560, kOblique, 2));
}

TEST(TurnedForLongFaces, BundlesOfWhichSomeRunElsewhereHaveThePairsOfEachWithEach) {
  std::vector<Vec3> directions(7, kOblique[0]);
  directions.insert(directions.end(), {{0, 5, 5}, {5, -5, 1}});
  expect_pairs_of_each_with_each(bundles(560, directions, 9));
}

/// Returns the mean ratio of the second longest side of a face's box to the longest.
double mean_thickness(const FaceTree& tree) {
  double sum = 0.0;
  for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
    const TreeBox box = tree.node(0, slot / 8).box(slot % 8);
    std::array<double, 3> widths{};
    for (std::size_t k = 0; k < 3; ++k) widths[k] = double{box.high[k]} - double{box.low[k]};
    std::sort(widths.begin(), widths.end());
    sum += widths[1] / widths[2];
  }
  return sum / static_cast<double>(tree.n_faces());
}

TEST(TurnedForLongFaces, BoxesOfLongFacesBecomeThin) {
  for (const std::vector<Vec3>& directions : {std::vector<Vec3>{kOblique[1]}, kOblique}) {
    const CutMesh cut = build(bundles(900, directions, 3));
    const FaceTree tree(cut);
    const std::optional<FaceTree> turned = turned_for_long_faces(tree);
    ASSERT_TRUE(turned);
    EXPECT_GT(mean_thickness(tree), 0.4);
    EXPECT_LT(mean_thickness(*turned), 0.06);
    EXPECT_EQ(turned->bounds().min(), tree.bounds().min());
    EXPECT_EQ(turned->n_faces(), tree.n_faces());
  }
}

TEST(TurnedForLongFaces, BundlesTurnedAboutAnAxisOfTheFileAreFound) {
  // Half of them run along that axis.
  const Soup soup = bundles(900, {{0, 0, 7}, {4, 5, 0}, {0, 0, 7}, {5, -4, 0}}, 10);
  const CutMesh cut = build(soup);
  const std::optional<FaceTree> turned = turned_for_long_faces(FaceTree(cut));
  ASSERT_TRUE(turned);
  EXPECT_LT(mean_thickness(*turned), 0.06);
}

TEST(TurnedForLongFaces, OthersStayAsTheyAre) {
  const auto is_turned = [](const Soup& soup) {
    return turned_for_long_faces(FaceTree(build(soup))).has_value();
  };
  EXPECT_FALSE(is_turned(shapes::uv_sphere(40, 40)));
  // Long faces along an axis of the file, all over the place, few, tiny and huge.
  EXPECT_FALSE(is_turned(bundles(900, {{0, 0, 7}}, 4)));
  EXPECT_FALSE(is_turned(bundles(900, {{7, 0, 0}, {2, 3, 6}, {0, 5, 5}, {6, 3, -2}}, 5)));
  EXPECT_FALSE(is_turned(bundles(400, kOblique, 6)));
  const Soup many = bundles(900, kOblique, 7);
  EXPECT_TRUE(is_turned(many));
  EXPECT_FALSE(is_turned(shapes::scaled(many, 1e-200)));
  EXPECT_FALSE(is_turned(shapes::scaled(many, 1e200)));
  Soup with_far_vertex = many;
  with_far_vertex.positions[0] = {1e9, 0, 0};
  EXPECT_FALSE(is_turned(with_far_vertex));
}

TEST(TurnedForLongFaces, BoxesHoldThePlacesBeforeRounding) {
  // The faces lie in a plane through the middle of all, so that floats near 0 show the rounding.
  Soup flat = bundles(900, {kOblique[0], kOblique[1]}, 8);
  for (Vec3& p : flat.positions) p -= kOblique[2] * (p.dot(kOblique[2]) / 49.0);
  const CutMesh cut = build(shapes::translated(flat, {1000.1, -300.3, 70.7}));
  const FaceTree tree(cut);
  BoxFrame frame{.origin = tree.bounds().center()};
  for (int k = 0; k < 3; ++k) frame.axes.row(k) = kOblique[static_cast<std::size_t>(k)] / 7.0;
  const FaceTree turned(tree, frame);
  std::size_t n_off = 0;
  for (std::size_t slot = 0; slot < turned.n_faces(); ++slot) {
    const TreeBox box = turned.node(0, slot / 8).box(slot % 8);
    for (const Index v : turned.triangle(slot)) {
      const LongVec3 exact = frame.axes.cast<long double>() * (turned.point(v).cast<long double>() -
                                                               frame.origin.cast<long double>());
      const Vec3 place = exact.cast<double>();
      n_off += place == turned.placed(v) ? 0U : 1U;
      // To round, and to map, keeps the order.
      const std::array<float, 3> mapped = turned.map(place);
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_LE(box.low[k], mapped[k]) << slot;
        ASSERT_GE(box.high[k], mapped[k]) << slot;
      }
    }
  }
  EXPECT_GT(n_off, 1000U);
}

}  // namespace
}  // namespace meshalyzer
