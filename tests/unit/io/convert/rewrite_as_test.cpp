#include "meshalyzer/io/convert/rewrite_as.h"

#include "meshalyzer/base/bytes.h"
#include "meshalyzer/io/write.h"
#include "support/edited_file.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace meshalyzer {
namespace {

std::string lost(const RewrittenFile& file) {
  std::string text;
  for (const AttributeCount& count : file.lost) {
    text += text.empty() ? "" : ", ";
    text += attribute_text(count);
  }
  return text;
}

/// A quad and a triangle with a colour a vertex and a texture whose seam is the edge between them.
std::string textured_obj() {
  return "# a wall\nmtllib wall.mtl\n"
         "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\nv 2 0 0 0.2 0.4 0.6\n"
         "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 9 9\n"
         "usemtl brick\nf 1/1 2/2 3/3 4/4\nf 2/1 5/2 3/3\n";
}

TEST(RewriteAs, PlyHoldsPolygonsColoursAndTexture) {
  EditedFile file(textured_obj(), "a.obj");
  const RewrittenFile ply = file.rewritten_as(Format::Ply);
  EXPECT_EQ(ply.bytes,
            "ply\nformat ascii 1.0\ncomment a wall\nelement vertex 5\nproperty double x\n"
            "property double y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
            "property uchar blue\nelement face 2\nproperty list uchar int vertex_indices\n"
            "property list uchar float texcoord\nend_header\n"
            "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 255 255 255\n2 0 0 51 102 153\n"
            "4 0 1 2 3 8 0 0 1 0 1 1 0 1\n3 1 4 2 6 0 0 1 0 1 1\n");
  // No face names the last of the texture coordinates.
  EXPECT_EQ(lost(ply), "1 texture coordinate, 1 material, 1 other statement");
}

TEST(RewriteAs, OffHoldsTextureWithoutSeamsOnly) {
  EditedFile file(textured_obj(), "a.obj");
  const RewrittenFile off = file.rewritten_as(Format::Off);
  EXPECT_EQ(off.bytes,
            "COFF\n# a wall\n5 2 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n1 1 0 0 0 255 255\n"
            "0 1 0 255 255 255 255\n2 0 0 51 102 153 255\n4 0 1 2 3\n3 1 4 2\n");
  EXPECT_EQ(lost(off), "5 texture coordinates, 1 material, 1 other statement");
  EditedFile seamless(with(textured_obj(), "f 2/1 5/2 3/3\n", "f 2/2 5/5 3/3\n"), "a.obj");
  EXPECT_EQ(lost(seamless.rewritten_as(Format::Off)), "1 material, 1 other statement");
  EXPECT_NE(seamless.rewritten_as(Format::Off).bytes.find("\n2 0 0 51 102 153 255 9 9\n"),
            std::string::npos);
}

TEST(RewriteAs, WhatIsReadBackSaysTheSame) {
  EditedFile file(textured_obj(), "a.obj");
  EditedFile ply(file.rewritten_as(Format::Ply).bytes, "a.ply");
  EXPECT_EQ(ply.rewritten_as(Format::Obj).bytes,
            "# a wall\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\n"
            "v 2 0 0 0.2 0.4 0.6\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"
            "f 2/1 5/2 3/3\n");
  EXPECT_EQ(lost(ply.rewritten_as(Format::Obj)), "");
}

TEST(RewriteAs, BinaryPlySaysTheSameAsText) {
  EditedFile file(textured_obj(), "a.obj");
  EditedFile binary(file.rewritten_as(Format::Ply, Encoding::Binary).bytes, "a.ply");
  EditedFile text(file.rewritten_as(Format::Ply).bytes, "a.ply");
  EXPECT_EQ(binary.rewritten_as(Format::Off).bytes, text.rewritten_as(Format::Off).bytes);
  EXPECT_EQ(binary.rewritten_as(Format::Obj).bytes, text.rewritten_as(Format::Obj).bytes);
}

TEST(RewriteAs, EditsTakeAttributesInTheOtherFormatToo) {
  EditedFile file(textured_obj(), "a.obj");
  file.add_vertex({1.5, 0, 0});
  file.add_face({5, 4, 2}, made_of(2));
  const std::string bytes = file.rewritten_as(Format::Ply).bytes;
  // Halfway between the second and the last vertex.
  EXPECT_NE(bytes.find("\n1.5 0 0 26 179 77\n"), std::string::npos) << bytes;
  EXPECT_NE(bytes.find("\n3 5 4 2 6 0.5 0 1 0 1 1\n"), std::string::npos) << bytes;
}

TEST(RewriteAs, ColoursOfFacesGoBetweenPlyAndOff) {
  EditedFile file(
      "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2 255 0 51\n3 0 1 3 0.2 0.2 0.2 1.0\n"
      "3 1 2 3 7\n",
      "a.off");
  const RewrittenFile ply = file.rewritten_as(Format::Ply);
  EXPECT_NE(ply.bytes.find("\n3 0 1 2 255 0 51\n3 0 1 3 51 51 51\n3 1 2 3 255 255 255\n"),
            std::string::npos);
  // The third is a place in a table that the file does not hold.
  EXPECT_EQ(lost(ply), "1 face colour");
  EXPECT_EQ(lost(file.rewritten_as(Format::Obj)), "3 face colours");
  EditedFile back(ply.bytes, "a.ply");
  EXPECT_NE(back.rewritten_as(Format::Off).bytes.find("\n3 0 1 2 255 0 51 255\n"),
            std::string::npos);
}

TEST(RewriteAs, ElementsWithoutAColourBecomeWhiteWhereOthersHaveOneAndAreCounted) {
  EditedFile file("v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  EXPECT_NE(file.rewritten_as(Format::Ply).bytes.find("\n0 0 0 255 0 0\n1 0 0 255 255 255\n"),
            std::string::npos);
  EXPECT_EQ(lost(file.rewritten_as(Format::Ply)), "2 absent colours");
  EXPECT_EQ(lost(file.rewritten_as(Format::Off)), "2 absent colours");
  EXPECT_EQ(lost(file.rewritten_as(Format::Mesh)), "1 vertex colour");
  // OFF holds faces without a colour beside others, PLY does not.
  EditedFile faces("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 51\n3 0 2 1\n", "a.off");
  EXPECT_EQ(lost(faces.rewritten_as(Format::Ply)), "1 absent colour");
  EditedFile none("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(lost(none.rewritten_as(Format::Ply)), "");
}

TEST(RewriteAs, ObjHoldsVerticesWithoutAColourBesideOthers) {
  EditedFile file("OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off");
  const RewrittenFile obj = file.rewritten_as(Format::Obj);
  EXPECT_EQ(obj.bytes, "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(lost(obj), "");
}

TEST(RewriteAs, TextureAtSomeCornersOfAFaceIsCountedAsLost) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
  EditedFile file(points + "f 1/1 2/2 3/3\nf 4/2 3 2\n", "a.obj");
  const RewrittenFile ply = file.rewritten_as(Format::Ply);
  EXPECT_NE(ply.bytes.find("\n3 0 1 2 6 0 0 1 0 0 1\n3 3 2 1 0\n"), std::string::npos);
  EXPECT_EQ(lost(ply), "1 texture coordinate");
  EditedFile only_some(points + "f 1/1 2/2 3\n", "a.obj");
  EXPECT_EQ(lost(only_some.rewritten_as(Format::Ply)), "3 texture coordinates");
}

TEST(RewriteAs, IntensitiesThatArePrintedAsWholeNumbersAreNoBytes) {
  const auto first_colour = [](const std::string& others) {
    EditedFile file(
        "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 " + others + "\n0 1 0 " + others + "\n3 0 1 2 1 0 1\n",
        "a.off");
    const std::string bytes = file.rewritten_as(Format::Ply).bytes;
    const std::size_t begin = bytes.find("\n0 0 0 ") + 7;
    return bytes.substr(begin, bytes.find('\n', begin) - begin);
  };
  EXPECT_EQ(first_colour("0.2 0.4 0 1"), "255 0 0");
  EXPECT_EQ(first_colour("0 1 1 1"), "255 0 0");
  EXPECT_EQ(first_colour("0 2 255 255"), "1 0 0 1");
}

TEST(RewriteAs, IntensitiesAbove1AreNoBytes) {
  const auto first_vertex = [](const std::string& colour) {
    EditedFile file("v 0 0 0 " + colour + "\nv 1 0 0 0.5 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n", "a.obj");
    const std::string bytes = file.rewritten_as(Format::Off).bytes;
    const std::size_t begin = bytes.find("\n0 0 0 ") + 1;
    return bytes.substr(begin, bytes.find('\n', begin) - begin);
  };
  EXPECT_EQ(first_vertex("1.5 0.25 0"), "0 0 0 1.5 0.25 0.0 1.0");
  EXPECT_EQ(first_vertex("255.0 51 0"), "0 0 0 1.0 0.2 0.0 1.0");
}

TEST(RewriteAs, ColoursThatAreNoBytesStayWhatTheyAre) {
  EditedFile file("v 0 0 0 0.1 0.5 1\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n", "a.obj");
  EXPECT_NE(file.rewritten_as(Format::Ply).bytes.find("property float red\n"), std::string::npos);
  EXPECT_NE(file.rewritten_as(Format::Ply).bytes.find("\n0 0 0 0.1 0.5 1\n"), std::string::npos);
  EXPECT_NE(file.rewritten_as(Format::Off).bytes.find("\n0 0 0 0.1 0.5 1.0 1.0\n"),
            std::string::npos);
}

TEST(RewriteAs, NamedSolidsAreGroups) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  EditedFile file("solid left half\n" + facet + "endsolid\nsolid right\n" +
                      with(facet, "1 0 0\nvertex", "2 0 0\nvertex") + "endsolid right\n",
                  "a.stl");
  const RewrittenFile obj = file.rewritten_as(Format::Obj);
  EXPECT_NE(obj.bytes.find("g left half\nf 1 2 3\ng right\nf 1 4 3\n"), std::string::npos);
  EXPECT_EQ(lost(obj), "");
}

/// A binary file of one facet, with a header and an attribute word.
std::string binary_stl(std::string header) {
  header.resize(80, ' ');
  std::string bytes = header;
  append_little_endian(bytes, std::uint32_t{1});
  for (const float number : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) {
    append_little_endian(bytes, number);
  }
  append_little_endian(bytes, std::uint16_t{31});
  return bytes;
}

TEST(RewriteAs, WhatABinaryStlSaysIsACommentAndAProperty) {
  EditedFile file(binary_stl("made by hand"), "a.stl");
  const RewrittenFile ply = file.rewritten_as(Format::Ply);
  EXPECT_EQ(ply.bytes,
            "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 3\nproperty double x\n"
            "property double y\nproperty double z\nelement face 1\n"
            "property list uchar int vertex_indices\nproperty ushort attribute\nend_header\n"
            "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 31\n");
  EXPECT_EQ(lost(ply), "");
  const RewrittenFile obj = file.rewritten_as(Format::Obj);
  EXPECT_EQ(obj.bytes.substr(0, 15), "# made by hand\n");
  EXPECT_EQ(lost(obj), "1 attribute word");
  EXPECT_EQ(lost(EditedFile(binary_stl("\x01\x02"), "a.stl").rewritten_as(Format::Ply)),
            "1 header");
}

TEST(RewriteAs, ReferencesArePropertiesOfPly) {
  EditedFile file(
      "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 7\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
      "Quadrilaterals 1\n1 2 3 4 5\nTriangles 1\n1 2 4 -6\nEnd\n",
      "a.mesh");
  const RewrittenFile ply = file.rewritten_as(Format::Ply);
  EXPECT_NE(ply.bytes.find("property double z\nproperty int reference\nelement face 2\n"
                           "property list uchar int vertex_indices\nproperty int reference\n"),
            std::string::npos);
  EXPECT_NE(ply.bytes.find("\n0 0 0 7\n1 0 0 0\n1 1 0 0\n0 1 0 0\n4 0 1 2 3 5\n3 0 1 3 -6\n"),
            std::string::npos);
  EXPECT_EQ(lost(ply), "");
  EXPECT_EQ(lost(file.rewritten_as(Format::Obj)), "3 references");
}

TEST(RewriteAs, CommentsBeforeTheFirstRecordAreKept) {
  EditedFile file("# made\n#by hand\no a#b\nv 0 0 0 # here\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  const RewrittenFile native = file.rewritten_as(Format::Mesh);
  EXPECT_EQ(native.bytes.substr(0, 25), "# made\n#by hand\nVertex 1 ");
  EXPECT_EQ(file.rewritten_as(Format::Ply).bytes.substr(0, 54),
            "ply\nformat ascii 1.0\ncomment made\ncomment by hand\nelem");
}

TEST(RewriteAs, MeshOfTrianglesOnlyIsPrinted) {
  EditedFile file("Vertex 1 0 0 0\nVertex 2 1 0 0\nVertex 4 0 1 0\nFace 1 1 2 4\n", "a.mesh");
  for (const Format format : {Format::Obj, Format::Off, Format::Ply, Format::Stl}) {
    EXPECT_EQ(file.rewritten_as(format).bytes, print_mesh(file.soup(), format));
  }
}

TEST(RewriteAs, FaceWithoutAVertexMustBeGone) {
  EditedFile file("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9 3\n", "a.obj");
  file.drop_face(1);
  file.drop_face(1);
  const RewrittenFile off = file.rewritten_as(Format::Off);
  EXPECT_NE(off.bytes.find("\n3 1 0\n"), std::string::npos);
  EXPECT_EQ(lost(off), "");
}

}  // namespace
}  // namespace meshalyzer
