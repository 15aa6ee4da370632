#include "meshalyzer/io/obj.h"

#include "io_cases.h"
#include "support/same_soup.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

const std::string kFourVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Soup obj_soup(const std::string& text) {
  return parse_obj(text, "o.obj");
}

TEST(ParseObj, ReadsVerticesAndFaces) {
  const Soup soup = obj_soup(kFourVertices + "f 1 2 3\n");
  EXPECT_EQ(soup.format, Format::Obj);
  EXPECT_EQ(soup.positions[2], Vec3(1, 1, 0));
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(soup.vertex_ids.first, 1);
  EXPECT_EQ(soup.face_ids.first, 1);
  EXPECT_EQ(soup.face_lines, (std::vector<std::uint32_t>{5}));
}

TEST(ParseObj, PolygonsAreFanned) {
  const Soup soup = obj_soup(kFourVertices + "f 1 2 3 4\nf 1 2\nf 3\n");
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 1}, {2, 2, 2}}));
  EXPECT_EQ(soup.n_polygons, 1U);
  EXPECT_EQ(soup.face_lines, (std::vector<std::uint32_t>{5, 5, 6, 7}));
}

TEST(ParseObj, NegativeIndicesCountBackFromTheLineTheyStandOn) {
  const Soup soup = obj_soup("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -1 -2 -4\n");
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 2, 0}}));
}

TEST(ParseObj, PositiveIndicesMayNameLaterVertices) {
  EXPECT_EQ(obj_soup("f 1 2 3\n" + kFourVertices).triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(ParseObj, EveryFormOfACornerNamesItsVertex) {
  const Soup soup = obj_soup(
      kFourVertices + "vt 0 0\nvn 0 0 1\nf 1/ 2// 3/1\nf 1/1/1 2//1 3/1/\nf 2/-1/-1 3/9/9 4\n");
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {1, 2, 3}}));
  EXPECT_EQ(soup.corner_normals,
            (std::vector<Triangle>{
                {kNoIndex, kNoIndex, kNoIndex}, {0, 0, kNoIndex}, {0, kNoIndex, kNoIndex}}));
}

TEST(ParseObj, NormalsAreKeptByCorner) {
  const Soup soup = obj_soup(kFourVertices + "vn 0 0 1\nvn 0 1 0\nf 1//2 2//1 3//1 4//2\n");
  EXPECT_EQ(soup.normals, (std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}}));
  EXPECT_EQ(soup.corner_normals, (std::vector<Triangle>{{1, 0, 0}, {1, 0, 1}}));
}

TEST(ParseObj, NormalsThatNoFaceUsesLeaveEmptyCorners) {
  const Soup soup = obj_soup("vn 0 0 1\n" + kFourVertices + "f 1 2 3\n");
  EXPECT_EQ(soup.normals.size(), 1U);
  EXPECT_EQ(soup.corner_normals, (std::vector<Triangle>{{kNoIndex, kNoIndex, kNoIndex}}));
}

TEST(ParseObj, WithoutNormalsNoneAreKept) {
  EXPECT_TRUE(obj_soup(kFourVertices + "f 1//5 2//5 3//5\n").corner_normals.empty());
}

TEST(ParseObj, ABackslashJoinsTheNextLine) {
  const Soup soup = obj_soup(kFourVertices + "f 1/1/1 \\\r\n 2/1/1\\\n3 \\\n4\nf 1 2 3\n");
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
  EXPECT_EQ(soup.face_lines, (std::vector<std::uint32_t>{5, 5, 9}));
}

TEST(ParseObj, ABackslashInACommentJoinsNothing) {
  EXPECT_EQ(obj_soup("# C:\\models\\\nv 0 0 0\n").n_vertices(), 1U);
}

TEST(ParseObj, GroupsAndObjectsNameRunsOfFaces) {
  const Soup soup =
      obj_soup(kFourVertices + "f 1 2 3\no left side # comment\nf 1 2 3 4\ng a#1\ng\nf 1 2 3\n");
  ASSERT_EQ(soup.groups.size(), 3U);
  EXPECT_EQ(soup.groups[0].name, "left side");
  EXPECT_EQ(soup.groups[0].first_face, 1U);
  EXPECT_EQ(soup.groups[1].name, "a#1");
  EXPECT_EQ(soup.groups[1].first_face, 3U);
  EXPECT_EQ(soup.groups[2].name, "");
}

TEST(ParseObj, WeightsAndColoursAreSkipped) {
  const Soup soup = obj_soup("v 1 2 3 1.0\nv 1 2 3 0.5 0.5 0.5\nv 1 2 3 0.5 0.5 0.5 1\n");
  EXPECT_EQ(soup.positions, (std::vector<Vec3>{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}));
}

TEST(ParseObj, ColoursThatAreNoNumbersAreSkippedToo) {
  const Soup soup = obj_soup("v 1 2 3 nan -nan(ind) inf\nv 1 2 3 NaN\n");
  EXPECT_EQ(soup.positions, (std::vector<Vec3>{{1, 2, 3}, {1, 2, 3}}));
  EXPECT_EQ(
      begin_like(error_of([] { return obj_soup("v 1 nan 3 0 0 0\n"); }), "o.obj:1: \"nan\" is not"),
      "o.obj:1: \"nan\" is not");
  EXPECT_NE(error_of([] { return obj_soup("v 1 2 3 red green blue\n"); }), "accepted");
}

TEST(ParseObj, OtherStatementsOfTheFormatAreSkipped) {
  const Soup soup = obj_soup("mtllib a.mtl\nusemtl b\ns off\nl 1 2 \\\n3\np 1\nvp 1\nvt 0\n" +
                             kFourVertices + "f 1 2 3");
  EXPECT_EQ(soup.n_vertices(), 4U);
  EXPECT_EQ(soup.n_faces(), 1U);
}

TEST(ParseObj, AnIndexBeyondTheVerticesIsMissing) {
  const Soup soup = obj_soup(kFourVertices + "f 1 2 99\n");
  ASSERT_EQ(soup.missing.size(), 1U);
  EXPECT_EQ(soup.missing[0].id, 99);
  EXPECT_EQ(soup.triangles[0], (Triangle{0, 1, kNoIndex}));
}

TEST(ParseObj, RefusesWhatIsMalformedAtItsLine) {
  const std::vector<RefusedText> cases = {
      {"v 0 0 0\nvv 0 0 0\n", "o.obj:2: \"vv\" is no keyword of OBJ"},
      {"v 0 0\n", "o.obj:1: the line ends where a number should stand"},
      {"v 0 0 0 1 1\n", "o.obj:1: a vertex of 5 numbers"},
      {"v 0 0 0 1 1 1 1 1\n", "o.obj:1: a vertex of 8 numbers"},
      {"v 0 0 nan\n", "o.obj:1: \"nan\" is not a finite number"},
      {"v 0 0 a\n", "o.obj:1: \"a\" is not a number"},
      {"vn 0 0\n", "o.obj:1: the line ends where a number should stand"},
      {"vn 0 0 1 0\n", "o.obj:1: \"0\" stands where the line should end"},
      {kFourVertices + "f\n", "o.obj:5: a face without corners"},
      {kFourVertices + "f 0 1 2\n", "o.obj:5: index 0: indices count from 1"},
      {kFourVertices + "f 1 2 -5\n", "o.obj:5: index -5 reaches back beyond the first of 4"},
      {"f -1 -2 -3\n" + kFourVertices, "o.obj:1: index -1 reaches back"},
      {kFourVertices + "f 1 2 2147483648\n", "o.obj:5: index 2147483648 is beyond 2147483647"},
      {kFourVertices + "f 1 2 99999999999999999999\n",
       "o.obj:5: index 99999999999999999999 is beyond"},
      {kFourVertices + "f 1 2 3.0\n", "o.obj:5: \"3.0\" is no corner of a face"},
      {kFourVertices + "f 1 2 /3\n", "o.obj:5: \"/3\" is no corner of a face"},
      {kFourVertices + "f 1 2 3/1/1/1\n", "o.obj:5: \"3/1/1/1\" is no corner of a face"},
      {kFourVertices + "f 1 2 3/x\n", "o.obj:5: \"3/x\" is no corner of a face"},
      {kFourVertices + "f 1//0 2 3\n", "o.obj:5: index 0"},
      {kFourVertices + "f 1//-1 2 3\n", "o.obj:5: index -1 reaches back"},
      {kFourVertices + "f 1 2 \\\nx\n", "o.obj:6: \"x\" is no corner of a face"},
  };
  for (const auto& [text, begin] : cases) {
    EXPECT_EQ(begin_like(error_of([&] { return obj_soup(text); }), begin), begin) << text;
  }
}

TEST(PrintObj, ReadsBackToTheLastBit) {
  Soup soup = strip_of_hard_numbers(500);
  soup.format = Format::Obj;
  soup.normals = {{0, -0.0, 1}, {1e-300, 0, 0.1}};
  soup.corner_normals.assign(soup.n_faces(), {1, kNoIndex, 0});
  soup.groups = {{"first one", 0}, {"empty", 7}, {"second", 7}, {"", 498}};
  EXPECT_TRUE(same_soup(obj_soup(print_obj(soup)), soup));
}

}  // namespace
}  // namespace meshalyzer
