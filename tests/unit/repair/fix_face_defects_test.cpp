#include "meshalyzer/repair/fix_face_defects.h"

#include "support/same_soup.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using enum DefectCode;

const Soup& mesh_of(const FaceRepairResult& result) {
  EXPECT_EQ(result.repair.meshes.size(), 1U);
  return result.repair.meshes.front().tracked.soup;
}

std::vector<Index> indices(Index begin, Index end) {
  std::vector<Index> all;
  for (Index i = begin; i < end; ++i) all.push_back(i);
  return all;
}

/// The flat sheet [0, 4] x [0, 3] of 24 faces, three a body's faces: the rows of squares along x.
/// Vertex (x, y) is y * 5 + x.
Soup three_rows() {
  Soup soup = shapes::grid(4, 3);
  soup.format = Format::Obj;
  soup.groups = {{"south", 0}, {"middle", 8}, {"north", 16}};
  return soup;
}

bool has_vertex(const Triangle& t, Index v) {
  return std::find(t.begin(), t.end(), v) != t.end();
}

/// Splits an edge, in all its faces, at a point this far from its first end; the new faces join
/// their groups.
Soup with_split_edge(Soup soup, Index a, Index b, double distance) {
  const auto m = static_cast<Index>(soup.n_vertices());
  const Vec3 along = (soup.positions[b] - soup.positions[a]).normalized();
  soup.positions.push_back(soup.positions[a] + distance * along);
  std::vector<Triangle> faces;
  std::vector<Group> groups;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    for (const Group& group : soup.groups) {
      if (group.first_face == f) groups.push_back({group.name, static_cast<Index>(faces.size())});
    }
    Triangle t = soup.triangles[f];
    if (has_vertex(t, a) && has_vertex(t, b)) {
      Triangle far = t;
      std::replace(far.begin(), far.end(), a, m);
      std::replace(t.begin(), t.end(), b, m);
      faces.push_back(far);
    }
    faces.push_back(t);
  }
  soup.triangles = std::move(faces);
  soup.groups = std::move(groups);
  return soup;
}

RepairOptions with_open_border() {
  RepairOptions options;
  options.borders = Borders::Intended;
  return options;
}

TEST(FixFaceDefects, GoodBodyComesOutBitForBitAndNoFaceIsEdited) {
  Soup soup = shapes::cube();
  soup.format = Format::Obj;
  soup.groups = {{"first", 0}, {"none", 6}, {"second", 6}};
  const FaceRepairResult result = fix_face_defects(soup);
  EXPECT_TRUE(same_soup(mesh_of(result), soup));
  EXPECT_TRUE(result.edited.empty());
  EXPECT_TRUE(result.repair.log.operations.empty());
}

TEST(FixFaceDefects, EmptyMeshHasNoFaces) {
  const FaceRepairResult result = fix_face_defects({});
  EXPECT_EQ(mesh_of(result).n_faces(), 0U);
  EXPECT_TRUE(result.edited.empty());
}

TEST(FixFaceDefects, MeshWithoutGroupsIsRepairedAndNothingIsTracked) {
  const FaceRepairResult result = fix_face_defects(shapes::open_cube());
  EXPECT_EQ(mesh_of(result).n_faces(), 12U);
  EXPECT_TRUE(result.edited.empty());
}

TEST(FixFaceDefects, OnlyTheFaceThatWasEditedIsTracked) {
  // A face of the middle is given twice: what follows moves up by one.
  Soup soup = three_rows();
  soup.triangles.insert(soup.triangles.begin() + 16, soup.triangles[9]);
  soup.groups[2].first_face = 17;
  const FaceRepairResult result = fix_face_defects(soup, with_open_border());
  EXPECT_TRUE(same_soup(mesh_of(result), three_rows()));
  ASSERT_EQ(result.edited.size(), 1U);
  EXPECT_EQ(result.edited.front().group, "middle");
  EXPECT_EQ(result.edited.front().before, indices(8, 17));
  EXPECT_EQ(result.edited.front().after, indices(8, 16));
}

TEST(FixFaceDefects, TurnedFaceIsTurnedBackInItsGroup) {
  const std::array<Index, 1> one{20};
  const FaceRepairResult result =
      fix_face_defects(shapes::flipped(three_rows(), one), with_open_border());
  EXPECT_EQ(mesh_of(result).triangles.size(), 24U);
  ASSERT_EQ(result.edited.size(), 1U);
  EXPECT_EQ(result.edited.front().group, "north");
  EXPECT_EQ(result.edited.front().before, result.edited.front().after);
}

TEST(FixFaceDefects, ShortEdgeWithinAFaceIsCollapsed) {
  // From (1, 1), on the border of south and middle, a short way up.
  const Soup soup = with_split_edge(three_rows(), 6, 11, 1e-12);
  const FaceRepairResult result = fix_face_defects(soup, with_open_border());
  EXPECT_EQ(result.repair.before.count(DegenerateFacet), 2U);
  // The vertex on the border is the one that stays.
  EXPECT_TRUE(same_soup(mesh_of(result), three_rows()));
  ASSERT_EQ(result.edited.size(), 1U);
  EXPECT_EQ(result.edited.front().group, "middle");
  EXPECT_EQ(result.edited.front().before, indices(8, 18));
  EXPECT_EQ(result.edited.front().after, indices(8, 16));
}

TEST(FixFaceDefects, ShortEdgeOfACommonBorderStays) {
  // From (1, 1) along the border of south and middle to (2, 1): a needle in either.
  const Soup soup = with_split_edge(three_rows(), 6, 7, 1e-12);
  const FaceRepairResult result = fix_face_defects(soup, with_open_border());
  EXPECT_TRUE(same_soup(mesh_of(result), soup));
  EXPECT_TRUE(result.edited.empty());
  EXPECT_EQ(result.repair.meshes.front().remaining.count(DegenerateFacet), 2U);
  ASSERT_FALSE(result.repair.log.refusals.empty());
  EXPECT_FALSE(result.repair.log.refusals.front().reason.empty());
  // Where groups are but names it goes.
  EXPECT_TRUE(
      same_soup(fix_defects(soup, with_open_border()).meshes.front().tracked.soup, three_rows()));
}

TEST(FixFaceDefects, ComponentsStayInOneMesh) {
  Soup soup = shapes::merged(shapes::cube(), shapes::translated(shapes::cube(), {3, 0, 0}));
  soup.format = Format::Obj;
  soup.groups = {{"left", 0}, {"right", 12}};
  RepairOptions options;
  options.fixes.insert(Disjoint);
  EXPECT_TRUE(same_soup(mesh_of(fix_face_defects(soup, options)), soup));
}

TEST(FixFaceDefects, PatchJoinsAFaceAndIsTracked) {
  // The cube without its top, its walls one face of the body and its bottom another.
  Soup soup = shapes::open_cube();
  soup.format = Format::Obj;
  const auto is_bottom = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) { return soup.positions[v].z() == 0.0; });
  };
  const auto walls = std::stable_partition(soup.triangles.begin(), soup.triangles.end(), is_bottom);
  ASSERT_EQ(walls - soup.triangles.begin(), 2);
  soup.groups = {{"bottom", 0}, {"walls", 2}};
  const FaceRepairResult result = fix_face_defects(soup);
  EXPECT_EQ(result.repair.meshes.front().remaining.count(Hole), 0U);
  ASSERT_EQ(result.edited.size(), 1U);
  EXPECT_EQ(result.edited.front().group, "walls");
  EXPECT_EQ(result.edited.front().before, indices(2, 10));
  EXPECT_EQ(result.edited.front().after, indices(2, 12));
}

}  // namespace
}  // namespace meshalyzer
