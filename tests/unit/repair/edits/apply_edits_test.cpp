#include "meshalyzer/repair/edits/apply_edits.h"

#include "meshalyzer/repair/edits/internal/fresh_ids.h"
#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

std::vector<std::int64_t> face_ids(const Soup& soup) {
  std::vector<std::int64_t> ids;
  for (Index f = 0; f < soup.n_faces(); ++f) ids.push_back(soup.face_ids.of(f));
  return ids;
}

std::vector<std::int64_t> vertex_ids(const Soup& soup) {
  std::vector<std::int64_t> ids;
  for (Index v = 0; v < soup.n_vertices(); ++v) ids.push_back(soup.vertex_ids.of(v));
  return ids;
}

Edits removal(std::vector<Index> faces) {
  Edits edits;
  const Index op = edits.begin_operation();
  for (const Index face : faces) edits.removed_faces.push_back({op, face});
  return edits;
}

TEST(ApplyEdits, NoEditsLeaveTheSoupAsItIs) {
  const TrackedMesh tracked = track_mesh(shapes::icosphere(1));
  EXPECT_TRUE(same_soup(apply_edits(tracked, {}).soup, tracked.soup));
}

TEST(ApplyEdits, RemovedFaceLeavesAGapInTheIdsOfTheNativeFormat) {
  const TrackedMesh after = apply_edits(track_mesh(shapes::tetrahedron()), removal({1}));
  EXPECT_EQ(face_ids(after.soup), (std::vector<std::int64_t>{1, 3, 4}));
  EXPECT_EQ(after.face_keys, (std::vector<Index>{0, 2, 3}));
}

TEST(ApplyEdits, FormatsThatNumberSilentlyCloseTheGap) {
  Soup soup = shapes::tetrahedron();
  soup.format = Format::Off;
  soup.face_ids.first = 0;
  EXPECT_EQ(face_ids(apply_edits(track_mesh(soup), removal({1})).soup),
            (std::vector<std::int64_t>{0, 1, 2}));
}

TEST(ApplyEdits, VertexThatLosesItsLastFaceGoesWithIt) {
  // Two faces with nothing in common; vertex 6 is an orphan from the start.
  Soup soup = shapes::grid(1, 1);
  soup = shapes::merged(shapes::make({{0, 0, 5}, {1, 0, 5}, {0, 1, 5}}, {{0, 1, 2}}), soup);
  soup.positions.emplace_back(9, 9, 9);
  const TrackedMesh after = apply_edits(track_mesh(soup), removal({0}));
  EXPECT_EQ(vertex_ids(after.soup), (std::vector<std::int64_t>{4, 5, 6, 7, 8}));
  EXPECT_EQ(after.soup.triangles.size(), 2U);
  EXPECT_EQ(after.soup.positions.back(), Vec3(9, 9, 9));
}

TEST(ApplyEdits, OrphanGoesOnlyWhereAsked) {
  Soup soup = shapes::tetrahedron();
  soup.positions.insert(soup.positions.begin(), Vec3(9, 9, 9));
  for (Triangle& t : soup.triangles) t = {t[0] + 1, t[1] + 1, t[2] + 1};
  Edits edits;
  edits.removed_vertices.push_back({edits.begin_operation(), 0});
  const TrackedMesh after = apply_edits(track_mesh(soup), edits);
  EXPECT_TRUE(same_bits(after.soup.positions, shapes::tetrahedron().positions));
  EXPECT_EQ(after.soup.triangles, shapes::tetrahedron().triangles);
  EXPECT_EQ(vertex_ids(after.soup), (std::vector<std::int64_t>{2, 3, 4, 5}));
}

TEST(ApplyEdits, VertexInUseIsNotRemoved) {
  Edits edits;
  edits.removed_vertices.push_back({edits.begin_operation(), 0});
  const TrackedMesh tracked = track_mesh(shapes::tetrahedron());
  EXPECT_TRUE(same_soup(apply_edits(tracked, edits).soup, tracked.soup));
}

TEST(ApplyEdits, SkippedOperationsAreNotMade) {
  Edits edits = removal({0});
  edits.removed_faces.push_back({edits.begin_operation(), 1});
  const std::array<std::uint8_t, 2> skipped{1, 0};
  const TrackedMesh after = apply_edits(track_mesh(shapes::tetrahedron()), edits, skipped);
  EXPECT_EQ(after.face_keys, (std::vector<Index>{0, 2, 3}));
}

TEST(ApplyEdits, AddedFaceComesLastOfItsGroup) {
  Soup soup = shapes::grid(2, 1);  // Faces 0, 1 in a, 2, 3 in b.
  soup.groups = {{"a", 0}, {"b", 2}};
  Edits edits;
  const Index op = edits.begin_operation();
  edits.added_vertices.push_back({op, Vec3(0, 0, 1)});
  edits.added_faces.push_back({op, {0, 1, 6}, 3, true});
  edits.added_faces.push_back({op, {1, 0, 6}, 0});
  const TrackedMesh after = apply_edits(track_mesh(soup), edits);
  EXPECT_EQ(after.face_keys, (std::vector<Index>{0, 1, 5, 2, 3, 4}));
  ASSERT_EQ(after.soup.groups.size(), 2U);
  EXPECT_EQ(after.soup.groups[1].first_face, 3U);
  EXPECT_EQ(face_ids(after.soup), (std::vector<std::int64_t>{1, 2, 5, 3, 4, 6}));
  EXPECT_EQ(after.origin_of_face(2), 0U);
  EXPECT_EQ(after.origin_of_face(5), kNoIndex);
}

TEST(ApplyEdits, CopyOfAVertexWhereASheetWasCutIsSuchAVertex) {
  Edits cut;
  const Index op = cut.begin_operation();
  cut.added_vertices.push_back({.op = op, .position = Vec3(0, 0, 0)});
  cut.added_vertices.push_back({.op = op, .position = Vec3(1, 0, 0)});
  cut.changed_faces.push_back({op, 0, {4, 2, 5}});
  cut.sheet_cuts = {{op, 2}, {op, 4}};
  const TrackedMesh after = apply_edits(track_mesh(shapes::tetrahedron()), cut);
  EXPECT_EQ(after.sheet_cuts, (std::vector<Index>{2, 4}));
  Edits split;
  const Index next = split.begin_operation();
  split.added_vertices.push_back({.op = next, .position = Vec3(0, 0, 0), .copy_of = 4});
  split.added_vertices.push_back({.op = next, .position = Vec3(1, 0, 0), .copy_of = 5});
  split.changed_faces.push_back({next, 1, {6, 7, 0}});
  EXPECT_EQ(apply_edits(after, split).sheet_cuts, (std::vector<Index>{2, 4, 6}));
}

TEST(ApplyEdits, CopyKnowsItsVertex) {
  Edits edits;
  const Index op = edits.begin_operation();
  edits.added_vertices.push_back({op, Vec3(0, 0, 0), 0});
  edits.changed_faces.push_back({op, 0, {4, 2, 1}});
  const TrackedMesh after = apply_edits(track_mesh(shapes::tetrahedron()), edits);
  ASSERT_EQ(after.vertex_keys.size(), 5U);
  EXPECT_EQ(after.vertex_keys[4], 4U);
  EXPECT_EQ(after.vertex_origins, (std::vector<Index>{0}));
  EXPECT_EQ(after.soup.triangles[0], (Triangle{4, 2, 1}));
  EXPECT_EQ(vertex_ids(after.soup).back(), 5);
}

TEST(ApplyEdits, IdsThatCannotGrowTakeTheSmallestThatAreFree) {
  Soup soup = shapes::tetrahedron();
  soup.face_ids.named = {1, 2, std::numeric_limits<std::int32_t>::max(), 4};
  Edits edits;
  edits.added_faces.push_back({edits.begin_operation(), {0, 1, 2}, 0});
  EXPECT_EQ(face_ids(apply_edits(track_mesh(soup), edits).soup).back(), 3);
}

TEST(ApplyEdits, NormalsOfVerticesFollowTheirVertices) {
  Soup soup = shapes::tetrahedron();
  soup.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};
  soup.corner_normals = soup.triangles;
  Edits edits;
  const Index op = edits.begin_operation();
  edits.added_vertices.push_back({op, Vec3(0, 0, 0), 2});
  edits.added_faces.push_back({op, {0, 1, 4}, 0});
  const TrackedMesh after = apply_edits(track_mesh(soup), edits);
  EXPECT_EQ(after.soup.corner_normals, after.soup.triangles);
  ASSERT_EQ(after.soup.normals.size(), 5U);
  EXPECT_EQ(after.soup.normals[4], Vec3(0, 0, 1));
}

/// A triangle whose first edge is halved by an added vertex, 3, and an operation that adds both
/// halves.
struct HalvedTriangle {
  Soup soup = shapes::make({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  Edits edits;

  explicit HalvedTriangle(std::vector<Vec3> normals) {
    soup.normals = std::move(normals);
    const Index op = edits.begin_operation();
    edits.added_vertices.push_back({op, Vec3(2, 0, 0)});
    edits.removed_faces.push_back({op, 0});
    edits.added_faces.push_back({op, {0, 3, 2}, 0});
    edits.added_faces.push_back({op, {3, 1, 2}, 0});
  }
};

TEST(ApplyEdits, PartsOfAFaceHaveTheNormalsThatItHasThere) {
  // Half-way from a normal of length 1 to another one, as textbooks of shading interpolate.
  const Vec3 between = Vec3(0.6, 0, 1.8).normalized();
  HalvedTriangle halved({{0, 0, 1}, {0.6, 0, 0.8}, {0, 1, 0}});
  halved.soup.corner_normals = {{0, 1, 2}};
  halved.soup.format = Format::Ply;
  const Soup of_vertices = apply_edits(track_mesh(halved.soup), halved.edits).soup;
  ASSERT_EQ(of_vertices.normals.size(), 4U);
  EXPECT_NEAR((of_vertices.normals[3] - between).norm(), 0.0, 1e-15);

  // Corners name their normals in another order than their vertices.
  halved.soup.format = Format::Obj;
  std::swap(halved.soup.normals[0], halved.soup.normals[2]);
  halved.soup.corner_normals = {{2, 1, 0}};
  const Soup of_corners = apply_edits(track_mesh(halved.soup), halved.edits).soup;
  for (const Triangle& t : of_corners.corner_normals) {
    for (const Index normal : t) ASSERT_NE(normal, kNoIndex);
  }
  EXPECT_NEAR((of_corners.normals[of_corners.corner_normals[0][1]] - between).norm(), 0.0, 1e-15);
  EXPECT_EQ(of_corners.corner_normals[0][0], 2U);
  EXPECT_EQ(of_corners.corner_normals[1][1], 1U);
}

TEST(ApplyEdits, PartsThatFaceTheOtherWayHaveTheOppositeNormals) {
  HalvedTriangle halved({{0.6, 0, 0.8}, {0.6, 0, -0.8}});
  halved.soup.format = Format::Obj;
  for (Edits::AddedFace& face : halved.edits.added_faces) {
    std::swap(face.corners[1], face.corners[2]);
  }
  // A normal that agreed with the face is turned; one that did not agrees now.
  for (const Index given : {0U, 1U}) {
    halved.soup.corner_normals = {{given, given, given}};
    const Soup after = apply_edits(track_mesh(halved.soup), halved.edits).soup;
    for (const Triangle& t : after.corner_normals) {
      for (const Index normal : t) {
        EXPECT_EQ(after.normals[normal], given == 0 ? Vec3(-0.6, 0, -0.8) : Vec3(0.6, 0, -0.8));
      }
    }
  }
}

TEST(ApplyEdits, InterpolatedNormalsAreNotOpposedToTheirFace) {
  // Half-way between the first two normals it points down.
  HalvedTriangle halved({{0.6, 0, 0.8}, {0, 0, -1}, {0, 0.6, 0.8}});
  halved.soup.corner_normals = {{0, 1, 2}};
  halved.soup.format = Format::Ply;
  EXPECT_EQ(apply_edits(track_mesh(halved.soup), halved.edits).soup.normals[3], Vec3(0, 0, 1));

  halved.soup.format = Format::Obj;
  halved.soup.normals.emplace_back(1, 0, 0);
  const Soup after = apply_edits(track_mesh(halved.soup), halved.edits).soup;
  EXPECT_EQ(after.normals[after.corner_normals[0][1]], Vec3(0, 0, 1));
  EXPECT_EQ(after.corner_normals[1][1], 1U);
}

TEST(ApplyEdits, PartsOfAFaceWithOneNormalHaveThatNormal) {
  HalvedTriangle halved({{0.1, 0.2, 0.3}});
  halved.soup.format = Format::Obj;
  halved.soup.corner_normals = {{0, 0, 0}};
  const Soup after = apply_edits(track_mesh(halved.soup), halved.edits).soup;
  EXPECT_EQ(after.corner_normals, (std::vector<Triangle>{{0, 0, 0}, {0, 0, 0}}));
}

TEST(ApplyEdits, NewVertexBetweenFacesHasTheMeanOfTheirNormals) {
  // Two faces at a right angle are cut where they meet, each with the same normal at all corners.
  Soup soup = shapes::make({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {0, 0, -4}},
                           {{0, 1, 2}, {3, 4, 5}});
  soup.format = Format::Ply;
  soup.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  soup.corner_normals = soup.triangles;
  Edits edits;
  const Index op = edits.begin_operation();
  edits.added_vertices.push_back({op, Vec3(2, 0, 0)});
  for (Index f = 0; f < 2; ++f) edits.removed_faces.push_back({op, f});
  for (const Triangle& part : {Triangle{0, 6, 2}, Triangle{6, 1, 2}}) {
    edits.added_faces.push_back({op, part, 0});
  }
  for (const Triangle& part : {Triangle{3, 6, 5}, Triangle{6, 4, 5}}) {
    edits.added_faces.push_back({op, part, 1});
  }
  const Soup after = apply_edits(track_mesh(soup), edits).soup;
  EXPECT_LT((after.normals[6] - Vec3(0, 1, 1).normalized()).norm(), 1e-15);
  EXPECT_EQ(after.normals[0], Vec3(0, 0, 1));
}

TEST(ApplyEdits, PatchHasNoNormalsOfOtherFaces) {
  HalvedTriangle halved({{1, 0, 0}, {0, 1, 0}, {1, 0, 0}});
  for (Edits::AddedFace& face : halved.edits.added_faces) face.fills_hole = true;
  halved.soup.format = Format::Obj;
  halved.soup.corner_normals = {{0, 0, 0}};
  const Soup of_corners = apply_edits(track_mesh(halved.soup), halved.edits).soup;
  EXPECT_EQ(of_corners.corner_normals, (std::vector<Triangle>{kNoTriangle, kNoTriangle}));

  // Where each vertex must have one, it is that of the patch.
  halved.soup.format = Format::Ply;
  halved.soup.corner_normals = {{0, 1, 2}};
  const Soup of_vertices = apply_edits(track_mesh(halved.soup), halved.edits).soup;
  ASSERT_EQ(of_vertices.normals.size(), 4U);
  EXPECT_EQ(of_vertices.normals[3], Vec3(0, 0, 1));
  EXPECT_EQ(of_vertices.normals[1], Vec3(0, 1, 0));
}

TEST(ApplyEdits, NormalsOfCornersStayWithTheirVertexWhenAFaceIsTurned) {
  Soup soup = shapes::tetrahedron();
  soup.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.corner_normals.assign(4, {kNoIndex, kNoIndex, kNoIndex});
  soup.corner_normals[0] = {0, 1, 2};
  const Triangle old = soup.triangles[0];
  Edits edits;
  edits.changed_faces.push_back({edits.begin_operation(), 0, {old[0], old[2], old[1]}});
  const TrackedMesh after = apply_edits(track_mesh(soup), edits);
  EXPECT_EQ(after.soup.corner_normals[0], (Triangle{0, 2, 1}));
  EXPECT_EQ(after.soup.corner_normals[1], (Triangle{kNoIndex, kNoIndex, kNoIndex}));
}

TEST(ApplyEdits, FaceThatLacksACornerKeepsItsNormals) {
  Soup soup = shapes::tetrahedron();
  soup.format = Format::Obj;
  soup.normals = {{1, 0, 0}, {0, 1, 0}};
  soup.corner_normals.assign(4, {0, 1, 0});
  soup.triangles[1][2] = kNoIndex;
  const TrackedMesh after = apply_edits(track_mesh(soup), removal({0}));
  EXPECT_EQ(after.soup.corner_normals, (std::vector<Triangle>(3, {0, 1, 0})));
}

TEST(ApplyEdits, ChangedNormalReplacesThatOfTheCornersThatHaveIt) {
  Soup soup = shapes::tetrahedron();
  soup.normals = {{1, 0, 0}, {0, 1, 0}};
  soup.corner_normals.assign(4, {0, 0, 0});
  soup.corner_normals[2] = {1, 1, 1};
  soup.corner_normals[3] = {kNoIndex, kNoIndex, kNoIndex};
  Edits edits;
  edits.changed_normals.push_back({edits.begin_operation(), 0, 0, Vec3(0, 0, -1)});
  const TrackedMesh after = apply_edits(track_mesh(soup), edits);
  for (std::size_t f = 0; f < 4; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_replaced = soup.triangles[f][k] == 0 && f < 2;
      EXPECT_EQ(after.soup.corner_normals[f][k], is_replaced ? 2U : soup.corner_normals[f][k]);
    }
  }
  EXPECT_EQ(after.soup.normals.back(), Vec3(0, 0, -1));
}

TEST(FreshIds, BesideNegativeOnesBeginAtOne) {
  using Ids32 = std::vector<std::int32_t>;
  EXPECT_EQ(fresh_ids({-3, -8}, 2), (Ids32{1, 2}));
  EXPECT_EQ(fresh_ids({-3, std::numeric_limits<std::int32_t>::max()}, 2), (Ids32{1, 2}));
}

}  // namespace
}  // namespace meshalyzer
