#include "meshalyzer/io/rewrite/rewrite.h"

#include "meshalyzer/base/bytes.h"
#include "meshalyzer/base/error.h"
#include "support/edited_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

TEST(RewriteNative, EditsTouchTheirLinesOnly) {
  const std::string text =
      "# a comment\nVertex 1 0.0 0 0\nVertex 5 1.0 0 0 # second\n\nVertex 7 0 1.0 0\nFace 3 1 5 "
      "7\n";
  EditedFile file(text, "a.mesh");
  EXPECT_EQ(file.rewritten_bytes(), text);
  file.soup().positions[1].z() = 2;
  std::swap(file.soup().triangles[0][0], file.soup().triangles[0][1]);
  EXPECT_EQ(file.rewritten_bytes(),
            with(with(text, "1.0 0 0 #", "1.0 0 2 #"), "3 1 5 7", "3 5 1 7"));
}

TEST(RewriteNative, TornLineGoesWhereTheMeshHasNoneLeft) {
  EditedFile file("Vertex 1 0 0 0\nVertex 2 1 0 0\n3 0 1 0\nVertex 3 0 1 0\nFace 1 1 2 3\n",
                  "a.mesh");
  EXPECT_EQ(file.rewritten_bytes(), file.bytes());
  file.soup().torn_lines.clear();
  EXPECT_EQ(file.rewritten_bytes(),
            "Vertex 1 0 0 0\nVertex 2 1 0 0\nVertex 3 0 1 0\nFace 1 1 2 3\n");
}

TEST(RewriteNative, RefusesAFaceThatWouldGetAnEarlierVertex) {
  EditedFile file("Vertex 1 0 0 0\nVertex 2 1 0 0\nVertex 3 0 1 0\nVertex 2 7 7 7\nFace 1 1 2 3\n",
                  "a.mesh");
  EXPECT_EQ(file.rewritten_bytes(), file.bytes());
  file.soup().triangles[0][1] = 3;
  EXPECT_THROW(static_cast<void>(file.rewritten()), InvalidArgument);
}

/// Expects that a file with one polygon, whose triangles are turned over, names its vertices in the
/// opposite order, beginning with the same one.
void expect_turned_polygon(const std::string& text, const std::string& path,
                           const std::string& before, const std::string& after) {
  EditedFile file(text, path);
  EXPECT_EQ(file.rewritten_bytes(), text);
  for (Triangle& t : file.soup().triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(file.rewritten_bytes(), with(text, before, after));
}

TEST(RewritePolygon, ThatIsTurnedIsAPolygonTheOtherWayRound) {
  expect_turned_polygon("OFF\n5 1 0\n0 0 0\n2 0 0\n2 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4  255 0 0\n",
                        "a.off", "5 0 1 2 3 4", "5 0 4 3 2 1");
  expect_turned_polygon(
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n2 0 0\n2 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4\n",
      "a.ply", "5 0 1 2 3 4", "5 0 4 3 2 1");
  expect_turned_polygon(
      "MeshVersionFormatted 1\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
      "Quadrilaterals\n1\n1 2 3 4 7\nEnd\n",
      "a.mesh", "1 2 3 4 7", "1 4 3 2 7");
}

TEST(RewriteOff, FacesOfAPolygonHaveItsColour) {
  EditedFile file("OFF # quad\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3  255 0 0\n", "a.off");
  EXPECT_EQ(file.rewritten_bytes(), file.bytes());
  std::swap(file.soup().triangles[1][0], file.soup().triangles[1][1]);
  EXPECT_EQ(file.rewritten_bytes(),
            "OFF # quad\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 2 0 3 255 0 0\n");
}

TEST(RewriteOff, VertexOnAnEdgeHasAMeanColour) {
  EditedFile file("COFF\n3 1 0\n0 0 0 0 0 0 255\n1 0 0 200 0 0 255\n0 1 0 0 0 9 255\n3 0 1 2\n",
                  "a.off");
  file.add_vertex({0.5, 0, 0});
  file.add_face({3, 1, 2}, made_of(0));
  EXPECT_NE(file.rewritten_bytes().find("\n0.5 0 0 100 0 0 255\n"), std::string::npos);
}

TEST(RewriteOff, VertexOnAnEdgeHasMeansOfIntensitiesAndTextureThatArePrintedAsWholeNumbers) {
  EditedFile file(
      "STCOFF\n3 1 0\n0 0 0 1 0 0 1 0 0\n1 0 0 0 0 1 1 1 0\n0 1 0 1 0.5 0 1 0 1\n3 0 1 2\n",
      "a.off");
  file.add_vertex({0.5, 0, 0});
  file.add_face({3, 1, 2}, made_of(0));
  EXPECT_NE(file.rewritten_bytes().find("\n0.5 0 0 0.5 0.0 0.5 1.0 0.5 0\n"), std::string::npos)
      << file.rewritten_bytes();
}

TEST(RewriteOff, MeanOfColoursThatAreNoNumbersCanBeRead) {
  EditedFile file("COFF\n3 1 0\n0 0 0 nan 0.5 0 1\n1 0 0 1 0 inf 1\n0 1 0 1 1 0 1\n3 0 1 2\n",
                  "a.off");
  file.add_vertex({0.5, 0, 0});
  file.add_face({3, 1, 2}, made_of(0));
  EXPECT_EQ(file.read_back().n_vertices(), 4U);
}

TEST(RewriteOff, VertexOnAnEdgeHasAMeanTextureBesideBytes) {
  EditedFile file("STCOFF\n3 1 0\n0 0 0 1 0 0 0 0\n1 0 0 0 0 200 1 0\n0 1 0 1 1 0 0 1\n3 0 1 2\n",
                  "a.off");
  file.add_vertex({0.5, 0, 0});
  file.add_face({3, 1, 2}, made_of(0));
  EXPECT_NE(file.rewritten_bytes().find("\n0.5 0 0 1 0 100 0.5 0\n"), std::string::npos)
      << file.rewritten_bytes();
}

TEST(RewriteOff, VertexOfNothingHasWhatTheKeywordDeclares) {
  const auto added = [](const std::string& keyword, const std::string& extra) {
    const std::string end = extra + "\n";
    EditedFile file(keyword + "\n3 1 0\n0 0 0" + end + "1 0 0" + end + "0 1 0" + end + "3 0 1 2\n",
                    "a.off");
    for (const double x : {5, 6, 7}) file.add_vertex({x, x * x, 0});
    file.add_face({3, 4, 5}, {});
    return file.rewritten_bytes();
  };
  EXPECT_NE(added("OFF", "").find("\n5 25 0\n"), std::string::npos);
  EXPECT_NE(added("STOFF", " 1 1").find("\n5 25 0 0 0\n"), std::string::npos);
  EXPECT_NE(added("COFF", " 9 9 9").find("\n5 25 0 255 255 255 255\n"), std::string::npos);
  EXPECT_NE(added("STCOFF", " 0.5 0.5 0.5 1.0 1 1").find("\n5 25 0 1.0 1.0 1.0 1.0 0 0\n"),
            std::string::npos);
}

/// Returns what is lost where the first corner of the second of two triangles, the fourth vertex,
/// is merged into the first vertex.
std::string lost_by_merge(const std::string& text, const std::string& name) {
  EditedFile file(text, name);
  file.soup().triangles[1][0] = 0;
  file.drop_vertex(3);
  std::string lost;
  const RewrittenFile rewritten = file.rewritten().value();
  for (const AttributeCount& count : rewritten.lost) {
    lost += (lost.empty() ? "" : ", ") + attribute_text(count);
  }
  return lost;
}

TEST(RewriteMerged, WhatTheDroppedVertexHadIsLostWhereTheOtherHasSomethingElse) {
  const auto off = [](const std::string& dropped) {
    return "STCNOFF\n5 2 0\n0 0 0 0 0 1 255 0 0 0.5 0\n1 0 0 0 0 1 9 9 9 0 0\n"
           "0 1 0 0 0 1 9 9 9 0 0\n" +
           dropped + "\n1 1 0 0 0 1 9 9 9 0 0\n3 0 1 2\n3 3 2 4\n";
  };
  EXPECT_EQ(lost_by_merge(off("0 0 0 0 0 1 255 0 0 .50 0"), "a.off"), "");
  EXPECT_EQ(lost_by_merge(off("0 0 0 0 0 1 254 0 0 0.5 1"), "a.off"),
            "1 texture coordinate, 1 vertex colour");
  const auto obj = [](const std::string& dropped) {
    return "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\n" + dropped + "\nv 1 1 0\nf 1 2 3\nf 4 3 5\n";
  };
  EXPECT_EQ(lost_by_merge(obj("v 0 0 0"), "a.obj"), "");
  EXPECT_EQ(lost_by_merge(obj("v 0 0 0 1 0 0"), "a.obj"), "");
  EXPECT_EQ(lost_by_merge(obj("v 0 0 0 0.5 1 0 1"), "a.obj"), "1 vertex colour, 1 vertex property");
  const auto ply = [](const std::string& dropped) {
    return "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
           "property float z\nproperty float s\nproperty float t\nproperty uchar red\n"
           "property int label\nproperty list uchar int parts\nelement face 2\n"
           "property list uchar int vertex_indices\nend_header\n0 0 0 0.5 0 7 1 1 4\n"
           "1 0 0 0 0 0 0 0\n0 1 0 0 0 0 0 0\n" +
           dropped + "\n1 1 0 0 0 0 0 0\n3 0 1 2\n3 3 2 4\n";
  };
  EXPECT_EQ(lost_by_merge(ply("0 0 0 0.50 0 7 1 1 4"), "a.ply"), "");
  EXPECT_EQ(lost_by_merge(ply("0 0 0 1 1 8 2 0"), "a.ply"),
            "1 texture coordinate, 1 vertex colour, 2 vertex properties");
  const auto medit_of = [](const std::string& reference) {
    return "MeshVersionFormatted 2\nDimension 3\nVertices 5\n0 0 0 1\n1 0 0 0\n0 1 0 0\n0 0 0 " +
           reference + "\n1 1 0 0\nTriangles 2\n1 2 3 0\n4 3 5 0\nEnd\n";
  };
  EXPECT_EQ(lost_by_merge(medit_of("01"), "a.mesh"), "");
  EXPECT_EQ(lost_by_merge(medit_of("2"), "a.mesh"), "1 reference");
}

/// Returns the file in which the fourth vertex is merged into the first one.
std::string merged_text(const std::string& text, const std::string& name) {
  EditedFile file(text, name);
  file.soup().triangles[1][0] = 0;
  file.drop_vertex(3);
  return file.rewritten_bytes();
}

TEST(RewriteMerged, RecordsThatNameTheDroppedVertexNameTheOther) {
  const std::string obj = merged_text(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 1 0\nf 1 2 3\nf 4 3 5\nl 4 5\nl 4 2 3 4\nl 1 4\n",
      "a.obj");
  EXPECT_NE(obj.find("\nl 1 4\nl 1 2 3 1\n"), std::string::npos) << obj;
  EXPECT_TRUE(obj.ends_with("l 1 2 3 1\n"));
  const std::string ply = merged_text(
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
      "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n0 0 0\n1 0 0\n"
      "0 1 0\n0 0 0\n1 1 0\n3 0 1 2\n3 3 2 4\n3 4\n0 3\n",
      "a.ply");
  EXPECT_NE(ply.find("element edge 1\n"), std::string::npos);
  EXPECT_TRUE(ply.ends_with("\n3 0 2 3\n0 3\n")) << ply;
  const std::string inria = merged_text(
      "MeshVersionFormatted 2\nDimension 3\nVertices 5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 0 0\n"
      "1 1 0 0\nTriangles 2\n1 2 3 0\n4 3 5 0\nEdges 2\n4 5 7\n1 4 8\nCorners 1\n4\nEnd\n",
      "a.mesh");
  EXPECT_TRUE(inria.ends_with("\nEdges 1\n1 4 7\nCorners 1\n1\nEnd\n")) << inria;
}

TEST(RewriteMerged, NormalOfTheDroppedVertexIsLostWhereTheOtherHasAnotherOne) {
  EditedFile file(
      "NOFF\n4 2 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 0 0 1 0\n3 0 1 2\n3 3 2 1\n",
      "a.off");
  file.soup().triangles[1][0] = 0;
  file.drop_vertex(3);
  EXPECT_EQ(attribute_text(file.rewritten()->lost.at(0)), "1 normal");
}

TEST(RewriteMerged, EndOfACollapsedEdgeIsNotMerged) {
  EditedFile file(
      "COFF\n5 3 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n0 0 0 0 0 9\n1 1 0 0 0 0\n3 0 1 2\n3 3 "
      "2 4\n"
      "3 0 2 3\n",
      "a.off");
  file.soup().triangles[1][0] = 0;
  file.drop_face(2);
  file.drop_vertex(3);
  EXPECT_TRUE(file.rewritten()->lost.empty());
}

TEST(RewriteMerged, VertexOfAFaceThatStaysNowhereIsNotMerged) {
  EditedFile file(
      "COFF\n4 2 0\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n0 0 0 0 0 9\n3 0 1 2\n3 3 2 1\n",
      "a.off");
  file.drop_face(1);
  file.drop_vertex(3);
  EXPECT_TRUE(file.rewritten()->lost.empty());
}

std::string textured_ply() {
  return "ply\nformat ascii 1.0\ncomment a wall\nelement vertex 4\nproperty float x\n"
         "property float y\nproperty float z\nproperty uchar red\nelement face 1\n"
         "property int label\nproperty list uchar uchar vertex_indices\n"
         "property list uchar float texcoord\nelement edge 1\nproperty int vertex1\n"
         "property int vertex2\nend_header\n"
         "0.0 0 0 10\n1.0 0 0 30\n1 1 0 50\n0 1 0 70\n"
         "7 4 0 1 2 3 8 0 0 1 0 1 1 0 1\n0 3\n";
}

TEST(RewritePly, WithoutEditsIsTheSameBytes) {
  EXPECT_EQ(EditedFile(textured_ply(), "a.ply").rewritten_bytes(), textured_ply());
}

TEST(RewritePly, TriangleOfAPolygonHasItsCornersOfTheTexture) {
  EditedFile file(textured_ply(), "a.ply");
  file.drop_face(0);
  EXPECT_EQ(file.rewritten_bytes(),
            with(textured_ply(), "7 4 0 1 2 3 8 0 0 1 0 1 1 0 1", "7 3 0 2 3 6 0 0 1 1 0 1"));
}

TEST(RewritePly, PatchHasTheNumbersOfAFaceBesideItAndNoTexture) {
  EditedFile file(textured_ply(), "a.ply");
  file.add_face({0, 2, 1}, beside(1));
  EXPECT_EQ(file.rewritten_bytes(), with(with(textured_ply(), "element face 1", "element face 2"),
                                         "1 0 1 1 0 1\n", "1 0 1 1 0 1\n7 3 0 2 1 0\n"));
}

TEST(RewritePly, IndexTypeGrowsWhereItHasTo) {
  EditedFile file(textured_ply(), "a.ply");
  for (int i = 0; i < 300; ++i) {
    file.add_vertex({0.5, 0.5, 1.0 + i});
    file.add_face({0, 1, static_cast<Index>(4 + i)}, made_of(0));
  }
  const Soup read = file.read_back();
  EXPECT_EQ(read.triangles, file.soup().triangles);
  EXPECT_NE(file.rewritten_bytes().find("property list uchar int vertex_indices"),
            std::string::npos);
}

TEST(RewritePly, IndexTypeStaysWhereItHoldsTheLargestIndex) {
  EditedFile file(textured_ply(), "a.ply");
  constexpr int kByteIndices = 256;
  for (int i = 4; i < kByteIndices; ++i) file.add_vertex({1.0 * i, 0, 1});
  file.add_face({0, kByteIndices - 2, kByteIndices - 1}, beside(0));
  EXPECT_NE(file.rewritten_bytes().find("property list uchar uchar vertex_indices"),
            std::string::npos);
}

TEST(RewritePly, RecordThatNamesADroppedVertexIsLost) {
  EditedFile file(textured_ply(), "a.ply");
  file.drop_face(1);
  file.drop_vertex(3);
  EXPECT_NE(file.rewritten_bytes().find("element edge 0\n"), std::string::npos);
  EXPECT_EQ(attribute_text(file.rewritten()->lost.at(0)), "1 polygon");
  EXPECT_EQ(attribute_text(file.rewritten()->lost.at(1)), "1 other record");
}

TEST(RewritePly, RecordWhoseTypeCannotNameTheVertexInTheOldPlaceIsLost) {
  std::string content =
      "ply\nformat ascii 1.0\nelement vertex 301\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
      "element edge 2\nproperty uchar vertex1\nproperty uchar vertex2\nend_header\n";
  for (int v = 0; v < 301; ++v) content += std::to_string(v) + " 0 " + std::to_string(v * v) + '\n';
  EditedFile file(content + "3 0 1 2\n3 2 1 300\n1 2\n1 0\n", "a.ply");
  file.soup().triangles[0][0] = 300;
  file.drop_vertex(0);
  const std::string bytes = file.rewritten_bytes();
  EXPECT_NE(bytes.find("element edge 1\n"), std::string::npos);
  EXPECT_TRUE(bytes.ends_with("\n3 299 0 1\n3 1 0 299\n0 1\n")) << bytes.substr(bytes.size() - 60);
  EXPECT_EQ(attribute_text(file.rewritten()->lost.at(0)), "1 other record");
}

/// A triangle with a colour a vertex and a number a face.
std::string binary_ply(std::endian order) {
  std::string content = "ply\nformat binary_";
  content += order == std::endian::little ? "little" : "big";
  content +=
      "_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nelement face 1\nproperty list uchar int vertex_indices\n"
      "property short label\nend_header\n";
  const auto append = [&](auto number) {
    std::string bytes;
    append_little_endian(bytes, number);
    content += order == std::endian::little ? bytes : std::string(bytes.rbegin(), bytes.rend());
  };
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
    for (const double coordinate : p) append(static_cast<float>(coordinate));
    append(std::uint8_t{200});
  }
  append(std::uint8_t{3});
  for (const std::int32_t corner : {0, 1, 2}) append(corner);
  append(std::int16_t{-5});
  return content;
}

TEST(RewritePly, BothBinaryEncodingsKeepTheirRecords) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    EditedFile file(binary_ply(order), "a.ply");
    EXPECT_EQ(file.rewritten_bytes(), file.bytes());
    file.add_face({0, 2, 1}, made_of(0));
    const std::string bytes = file.rewritten_bytes();
    EXPECT_EQ(file.read_back().triangles, file.soup().triangles);
    // Behind the records that were there stands one that ends with the same label.
    EXPECT_EQ(bytes.substr(bytes.size() - 2), file.bytes().substr(file.bytes().size() - 2));
    EXPECT_EQ(bytes.size(), file.bytes().size() + 15);
  }
}

TEST(RewritePly, CoordinateThatIsNoFloatMakesThePropertyDouble) {
  EditedFile file(binary_ply(std::endian::big), "a.ply");
  file.soup().positions[1].x() = 0.1;
  EXPECT_EQ(file.read_back().positions, file.soup().positions);
  EXPECT_NE(file.rewritten_bytes().find("property double x\nproperty float y\n"),
            std::string::npos);
}

std::string medit() {
  return "MeshVersionFormatted 2\nDimension 3\n# by hand\nVertices\n5\n0.0 0 0 1\n1 0 0 2\n1 1 0 "
         "3\n0 1 0 4\n"
         "9 9 9 5\nTriangles 1\n1 2 3 7\nQuadrilaterals 1\n1 2 3 4 8\nCorners 2\n1\n5\nEnd\n";
}

TEST(RewriteInria, WithoutEditsIsTheSameBytes) {
  EXPECT_EQ(EditedFile(medit(), "a.mesh").rewritten_bytes(), medit());
}

TEST(RewriteInria, IntegersStayInTheWordsOfTheFile) {
  const std::string text =
      with(with(medit(), "Vertices\n5", "Vertices\n+05"), "1 2 3 7", "01 2 3 7");
  EXPECT_EQ(EditedFile(text, "a.mesh").rewritten_bytes(), text);
}

TEST(RewriteInria, WhatIsLeftOfAQuadrilateralStandsBehindTheTriangles) {
  EditedFile file(medit(), "a.mesh");
  file.drop_face(1);
  file.add_face({0, 2, 1}, beside(0));
  EXPECT_EQ(
      file.rewritten_bytes(),
      with(with(with(medit(), "Triangles 1\n1 2 3 7\n", "Triangles 3\n1 2 3 7\n1 3 4 8\n1 3 2 0\n"),
                "Quadrilaterals 1", "Quadrilaterals 0"),
           "1 2 3 4 8\n", ""));
}

TEST(RewriteInria, RecordThatNamesADroppedVertexIsLost) {
  EditedFile file(medit(), "a.mesh");
  file.drop_vertex(4);
  EXPECT_EQ(file.rewritten_bytes(),
            with(with(with(medit(), "Vertices\n5", "Vertices\n4"), "9 9 9 5\n", ""),
                 "Corners 2\n1\n5\n", "Corners 1\n1\n"));
  EXPECT_EQ(attribute_text(file.rewritten()->lost.at(0)), "1 other record");
}

TEST(RewriteInria, RequiredTetrahedraMoveWithTheTetrahedraBeforeThem) {
  EditedFile file(with(medit(), "Corners 2\n1\n5\n",
                       "Tetrahedra 2\n1 2 3 5 0\n1 2 3 4 0\nRequiredTetrahedra 2\n1\n2\n"),
                  "a.mesh");
  file.drop_vertex(4);
  EXPECT_NE(file.rewritten_bytes().find("Tetrahedra 1\n1 2 3 4 0\nRequiredTetrahedra 1\n1\nEnd\n"),
            std::string::npos)
      << file.rewritten_bytes();
}

TEST(RewriteInria, SubdomainsFollowTheTriangleThatTheyName) {
  const std::string subdomains = "SubDomainFromMesh 2\n3 1 1 7\n3 2 -1 8\n";
  EditedFile file(with(with(medit(), "Triangles 1\n", "Triangles 2\n2 3 4 6\n"),
                       "Corners 2\n1\n5\n", subdomains + "SubDomain 1\n3 2 1 9\n"),
                  "a.mesh");
  file.drop_face(0);
  EXPECT_NE(
      file.rewritten_bytes().find("SubDomainFromMesh 1\n3 1 -1 8\nSubDomain 1\n3 1 1 9\nEnd\n"),
      std::string::npos)
      << file.rewritten_bytes();
  EXPECT_EQ(attribute_text({AttributeKind::OtherRecords, file.rewritten()->lost_records.size()}),
            "1 other record");
}

TEST(RewriteInria, CommentInADroppedRecordIsCountedAsLost) {
  EditedFile file(with(medit(), "9 9 9 5\n", "9 9 # far away\n9 5\n"), "a.mesh");
  file.drop_vertex(4);
  EXPECT_EQ(attribute_text(file.rewritten()->lost.at(1)), "1 comment");
}

}  // namespace
}  // namespace meshalyzer
