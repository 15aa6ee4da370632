#include "meshalyzer/repair/replace/internal/broken_boxes.h"
#include "support/shapes.h"
#include "unit/repair/repaired_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <vector>

namespace meshalyzer {
namespace {

/// A sphere with a vertex pulled over a neighbour, so that faces round it intersect.
Soup sphere_with_fold(Index vertex) {
  Soup soup = shapes::icosphere(3);
  const auto t = std::find_if(soup.triangles.begin(), soup.triangles.end(),
                              [&](const Triangle& f) { return f[0] == vertex; });
  const Vec3 along = soup.positions[(*t)[1]] - soup.positions[vertex];
  soup.positions[vertex] += 2.2 * along;
  return soup;
}

/// Options that leave nothing but replacements to mend intersections and holes.
RepairOptions by_replacement() {
  RepairOptions options;
  options.fixes.erase(DefectCode::SelfIntersection);
  options.fixes.erase(DefectCode::Foldover);
  options.fixes.erase(DefectCode::Hole);
  options.guarantee = true;
  options.max_deviation.value = 0.01;
  return options;
}

using Places = std::set<std::vector<double>>;

/// The corners of each face, in any order, whose corners all are farther from a point.
Places faces_beyond(const Soup& soup, const Vec3& point, double distance) {
  Places places;
  for (Index face = 0; face < soup.n_faces(); ++face) {
    std::vector<double> numbers;
    bool is_beyond = true;
    for (const Vec3& p : corners_of(soup, face)) {
      numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
      is_beyond = is_beyond && (p - point).norm() > distance;
    }
    if (is_beyond) places.insert(numbers);
  }
  return places;
}

bool was_replaced_in_boxes(const RepairResult& result) {
  return std::any_of(result.log.steps.begin(), result.log.steps.end(),
                     [](const LogStep& step) { return step.pass == "replace in boxes"; });
}

TEST(ReplaceInBoxes, OnlyWhatIsNearAFoldIsReplaced) {
  constexpr Index kVertex = 300;
  const Soup folded = sphere_with_fold(kVertex);
  const RepairResult result = fix_defects(folded, by_replacement());
  const Soup& made = only_mesh(result);
  EXPECT_TRUE(is_good(made));
  EXPECT_TRUE(was_replaced_in_boxes(result));
  EXPECT_LE(result.deviation, result.max_deviation);
  EXPECT_NEAR(volume_of(made), 4.0 / 3.0 * std::numbers::pi, 0.05);
  // The folded faces extend over less than 0.5.
  const Vec3& place = folded.positions[kVertex];
  const Places before = faces_beyond(folded, place, 0.75);
  const Places after = faces_beyond(made, place, 0.75);
  EXPECT_GT(before.size(), folded.n_faces() / 2);
  EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
}

TEST(ReplaceInBoxes, EachHoleHasABoxOfItsOwn) {
  const std::vector<Index> lost{0, 640};
  const Soup open = shapes::without_faces(shapes::icosphere(3), lost);
  const PreparedMesh mesh(open);
  EXPECT_EQ(boxes_round_broken_faces(mesh, 0.01).size(), 2U);
  // Boxes that meet are one.
  EXPECT_EQ(boxes_round_broken_faces(mesh, 1.0).size(), 1U);

  const RepairResult result = fix_defects(open, by_replacement());
  EXPECT_TRUE(is_good(only_mesh(result)));
  EXPECT_TRUE(was_replaced_in_boxes(result));
  EXPECT_GT(only_mesh(result).n_faces(), open.n_faces());
}

TEST(ReplaceInBoxes, BoxesHoldTheBrokenFacesAndTheMargin) {
  const Soup folded = sphere_with_fold(300);
  const PreparedMesh mesh(folded);
  const std::vector<Box3> boxes = boxes_round_broken_faces(mesh, 0.125);
  ASSERT_EQ(boxes.size(), 1U);
  Box3 tight;
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    for (const Index face : {pair.face_a, pair.face_b}) {
      for (const Vec3& corner : corners_of(folded, face)) tight.extend(corner);
    }
  }
  const Vec3 margin = Vec3::Constant(0.125);
  EXPECT_EQ(boxes[0].min(), tight.min() - margin);
  EXPECT_EQ(boxes[0].max(), tight.max() + margin);
  EXPECT_TRUE(boxes_round_broken_faces(PreparedMesh(shapes::cube()), 1.0).empty());
}

}  // namespace
}  // namespace meshalyzer
