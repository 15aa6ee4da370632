#include "support/edited_file.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

/// Two quads side by side with a texture, of two materials; a line and a comment.
std::string two_quads() {
  return "# made by hand\n"
         "mtllib wall.mtl\n"
         "v 0.000 0 0\nv 1.000 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
         "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
         "g left\nusemtl brick\ns 1\n"
         "f 1/1 2/2 3/3 4/4  # the left one\n"
         "g right\nusemtl glass\n"
         "f 2/1 5/2 6/3 3/4\n"
         "l 1 2 5\n";
}

EditedFile edited(const std::string& text) {
  return {text, "a.obj"};
}

TEST(RewriteObj, WithoutEditsIsTheSameBytes) {
  EXPECT_EQ(edited(two_quads()).rewritten_bytes(), two_quads());
}

TEST(RewriteObj, MovedVertexChangesTheNumbersThatChanged) {
  EditedFile file = edited(two_quads());
  file.soup().positions[1].y() = 0.25;
  EXPECT_EQ(file.rewritten_bytes(), with(two_quads(), "v 1.000 0 0", "v 1.000 0.25 0"));
}

TEST(RewriteObj, PatchStandsBehindTheFacesOfTheMaterialBesideIt) {
  EditedFile file = edited(two_quads());
  file.add_face({0, 3, 2}, beside(1));
  EXPECT_EQ(file.rewritten_bytes(),
            with(two_quads(), "# the left one\n", "# the left one\nf 1 4 3\n"));
  // It stands before the second quad, whose triangles were the third and fourth face.
  EXPECT_EQ(file.rewritten()->file_faces, (std::vector<Index>{0, 1, 3, 4, 2}));
}

TEST(RewriteObj, PatchStandsBehindLinesThatABackslashTakesToTheFace) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const auto& [last, with_patch] :
       std::vector<std::array<std::string, 2>>{{"f 1 2 3 \\\n\n", "f 1 2 3 \\\n\nf 1 3 2\n"},
                                               {"f 1 2 \\\n3\n", "f 1 2 \\\n3\nf 1 3 2\n"},
                                               {"f 1 2 3 \\\n", "f 1 2 3 \\\n\nf 1 3 2\n"},
                                               {"f 1 2 3 \\", "f 1 2 3 \\\n\nf 1 3 2\n"}}) {
    EditedFile file = edited(vertices + last);
    file.add_face({0, 2, 1}, beside(0));
    EXPECT_EQ(file.rewritten_bytes(), vertices + with_patch) << last;
    EXPECT_EQ(file.read_back().n_faces(), 2U) << last;
  }
}

TEST(RewriteObj, PolygonIsTrianglesWhereOneOfItsTrianglesIsDropped) {
  EditedFile file = edited(two_quads());
  file.drop_face(1);
  EXPECT_EQ(file.rewritten_bytes(), with(two_quads(), "f 1/1 2/2 3/3 4/4  # the left one\n",
                                         "f 1/1 2/2 3/3  # the left one\n"));
  EXPECT_EQ(attribute_text(file.rewritten()->lost.at(0)), "1 polygon");
}

TEST(RewriteObj, CommentThatGoesWithItsFaceIsCountedAsLost) {
  EditedFile file = edited(two_quads());
  file.drop_face(0);
  file.drop_face(0);
  EXPECT_EQ(file.rewritten_bytes(), with(two_quads(), "f 1/1 2/2 3/3 4/4  # the left one\n", ""));
  // No polygon is split: this one was dropped as a whole.
  ASSERT_EQ(file.rewritten()->lost.size(), 1u);
  EXPECT_EQ(attribute_text(file.rewritten()->lost[0]), "1 comment");
}

TEST(RewriteObj, TurnedPolygonIsAPolygonTheOtherWayRound) {
  EditedFile file = edited(two_quads());
  for (Index f : {0U, 1U}) {
    std::swap(file.soup().triangles[f][1], file.soup().triangles[f][2]);
  }
  EXPECT_EQ(file.rewritten_bytes(), with(two_quads(), "1/1 2/2 3/3 4/4", "1/1 4/4 3/3 2/2"));
  EXPECT_EQ(file.rewritten()->file_faces, (std::vector<Index>{1, 0, 2, 3}));
}

TEST(RewriteObj, TurnedTriangleTakesItsTextureAlong) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3 # it\n";
  EditedFile file = edited(text);
  std::swap(file.soup().triangles[0][1], file.soup().triangles[0][2]);
  EXPECT_EQ(file.rewritten_bytes(), with(text, "1/1 2/2 3/3", "1/1 3/3 2/2"));
}

TEST(RewriteObj, PolygonWhoseCornerIsAnotherVertexStaysAPolygon) {
  EditedFile file = edited(two_quads());
  // The right quad ends at a copy of the corner that it shared with the left one.
  file.add_vertex({1, 1, 0}, made_of(2));
  file.soup().triangles[2][2] = 5;
  file.soup().triangles[3] = {1, 5, 6};
  EXPECT_EQ(file.rewritten_bytes(), with(with(two_quads(), "v 2 1 0\n", "v 2 1 0\nv 1 1 0\n"),
                                         "f 2/1 5/2 6/3 3/4", "f 2/1 5/2 6/3 7/4"));
}

TEST(RewriteObj, CornerAtAnotherVertexHasAnInterpolatedTextureCoordinate) {
  EditedFile file = edited(two_quads());
  // A quarter of the way along the lower edge of the left quad, whose texture goes from 0 to 1.
  file.add_vertex({0.25, 0, 0});
  file.add_face({6, 1, 2}, made_of(0));
  const std::string bytes = file.rewritten_bytes();
  EXPECT_NE(bytes.find("v 2 1 0\nv 0.25 0 0\n"), std::string::npos);
  EXPECT_NE(bytes.find("vt 0 1\nvt 0.25 0\n"), std::string::npos);
  EXPECT_NE(bytes.find("# the left one\nf 7/5 2/2 3/3\n"), std::string::npos);
}

TEST(RewriteObj, SeamIsKeptAtAVertexThatBothSidesName) {
  EditedFile file = edited(two_quads());
  // Vertex 3 has texture coordinate 3 on the left quad and 4 on the right one.
  file.add_face({1, 4, 2}, made_of(2));
  EXPECT_NE(file.rewritten_bytes().find("f 2/1 5/2 3/4\n"), std::string::npos);
}

/// A square of two triangles whose texture coordinates are its places.
std::string textured_square() {
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
         "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
}

TEST(RewriteObj, CornerBeyondAnEdgeHasTheTextureOfTheFaceThere) {
  EditedFile file = edited(textured_square());
  file.soup().triangles = {{0, 1, 3}, {1, 2, 3}};
  EXPECT_EQ(file.rewritten_bytes(), with(with(textured_square(), "f 1/1 2/2 3/3", "f 1/1 2/2 4/4"),
                                         "f 1/1 3/3 4/4", "f 2/2 3/3 4/4"));
}

TEST(RewriteObj, CornerBeyondASeamHasATextureOfItsOwnFace) {
  // The other face has its texture upside down.
  const std::string text = with(textured_square(), "f 1/1 3/3 4/4", "f 1/3 3/1 4/2");
  EditedFile file = edited(text);
  file.soup().triangles[0] = {0, 1, 3};
  // The point of the face that is nearest to the corner is the middle of its diagonal.
  const std::string bytes = file.rewritten_bytes();
  EXPECT_NE(bytes.find("vt 0 1\nvt 0.5 0.5\n"), std::string::npos);
  EXPECT_NE(bytes.find("f 1/1 2/2 4/5\n"), std::string::npos);
}

TEST(RewriteObj, DroppedVertexMovesTheNumbersBehindIt) {
  const std::string text =
      "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 2/1 3/1 4/1\nf -3/-1 -2/-1 -1/-1\n";
  EditedFile file = edited(text);
  file.drop_vertex(0);
  EXPECT_EQ(file.rewritten_bytes(),
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf -3/-1 -2/-1 -1/-1\n");
}

TEST(RewriteObj, ManyDroppedVerticesBeforeManyFacesTakeNoTimeForEachFace) {
  // Going through the dropped vertices for each corner would take 10^10 steps.
  constexpr int kFaces = 20'000;
  constexpr int kUnused = 200'000;
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  std::string text = "v 9 9 9\n" + vertices;
  std::string expected = vertices;
  for (int i = 0; i < kUnused; ++i) text += "v 8 8 8\n";
  for (int i = 0; i < kFaces; ++i) {
    text += "f 2 3 4\n";
    expected += "f 1 2 3\n";
  }
  EditedFile file = edited(text);
  file.drop_unused_vertices();
  EXPECT_EQ(file.rewritten_bytes(), expected);
}

TEST(RewriteObj, LineThatLosesAVertexIsCountedAsLost) {
  EditedFile file = edited("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\nl 1 2\nl 3 4\n");
  file.drop_vertex(0);
  EXPECT_EQ(file.rewritten_bytes(), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 2 3\n");
  ASSERT_EQ(file.rewritten()->lost.size(), 1u);
  EXPECT_EQ(attribute_text(file.rewritten()->lost[0]), "1 line or point");
}

TEST(RewriteObj, CurvesAndSurfacesNameTheSameVerticesWhereOneBeforeThemIsDropped) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  EditedFile file = edited("v 9 9 9\n" + vertices +
                           "vt 0 0\nvn 0 0 1\nf 2 3 4\ncstype bezier\ndeg 1 1\n"
                           "curv 0 1 2 -1\nparm u 0 1\nend\nsurf 0 1 0 1 2/1/1 3//1 4/1 -1\n"
                           "bzp 5 4 3 2\n");
  file.drop_vertex(0);
  EXPECT_EQ(file.rewritten_bytes(), vertices +
                                        "vt 0 0\nvn 0 0 1\nf 1 2 3\ncstype bezier\ndeg 1 1\n"
                                        "curv 0 1 1 -1\nparm u 0 1\nend\n"
                                        "surf 0 1 0 1 1/1/1 2//1 3/1 -1\nbzp 4 3 2 1\n");
  EXPECT_TRUE(file.rewritten()->lost.empty());
}

TEST(RewriteObj, SurfaceThatLosesAVertexIsLostWithItsBodyAndTheConnections) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string kept = "f 1 2 3\ncurv 0 1 1 2\nparm u 0 1\nend\nsurf 0 1 0 1 1 2 3 1\nend\n";
  EditedFile file = edited(vertices + "v 9 9 9\n" + kept +
                           "surf 0 1 0 1 1 2 3 4\nparm u 0 1\ntrim 0 1 1\n\nend\n"
                           "con 1 0 1 1 2 0 1 1\n");
  file.drop_vertex(3);
  EXPECT_EQ(file.rewritten_bytes(), vertices + kept + "\n");
  EXPECT_EQ(attribute_text(file.rewritten()->lost.at(0)), "5 other statements");
}

TEST(RewriteObj, IntegersStayInTheWordsOfTheFile) {
  EditedFile file = edited("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf -03/-01 -2/01 03/1\n");
  EXPECT_EQ(file.rewritten_bytes(), file.bytes());
}

TEST(RewriteObj, AddedRecordsMoveReferencesThatCountBackBehindThem) {
  EditedFile file = edited("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n");
  file.add_vertex({0, 0, 1});
  file.add_face({0, 1, 3}, beside(0));
  EXPECT_EQ(file.rewritten_bytes(), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf -4 -3 -2\nf 1 2 4\n");
}

TEST(RewriteObj, CopyOfAVertexHasItsColour) {
  EditedFile file = edited("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3");
  file.add_vertex({0, 0, 0.5}, made_of(1));
  file.soup().triangles[0][1] = 3;
  EXPECT_EQ(file.rewritten_bytes(),
            "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 0 0 0.5 0 1 0\nf 1 4 3");
}

TEST(RewriteObj, NewNormalStandsBehindTheOthers) {
  EditedFile file = edited("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//1 2//1 3//1\n");
  file.soup().normals.emplace_back(0, 0, 1);
  file.soup().corner_normals[0] = {1, 1, 1};
  EXPECT_EQ(file.rewritten_bytes(),
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nvn 0 0 1\nf 1//2 2//2 3//2\n");
}

TEST(RewriteObj, LinesEndAsTheFirstOneDoes) {
  EditedFile file = edited("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3");
  file.add_face({0, 2, 1}, beside(0));
  EXPECT_EQ(file.rewritten_bytes(), "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\nf 1 3 2\r\n");
}

}  // namespace
}  // namespace meshalyzer
