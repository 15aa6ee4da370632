#include "meshalyzer/io/format_of.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(FormatOfName, IsThatOfTheEndingInAnyCase) {
  EXPECT_EQ(format_of_name("a/b.mesh"), Format::Mesh);
  EXPECT_EQ(format_of_name("b.OBJ"), Format::Obj);
  EXPECT_EQ(format_of_name("b.Off"), Format::Off);
  EXPECT_EQ(format_of_name("b.x.stl"), Format::Stl);
  EXPECT_EQ(format_of_name("b.ply"), Format::Ply);
}

TEST(FormatOfName, GzippedIsThatOfTheEndingBefore) {
  EXPECT_EQ(format_of_name("a.mesh.gz"), Format::Mesh);
  EXPECT_EQ(format_of_name("a.STL.GZ"), Format::Stl);
  EXPECT_EQ(format_of_name("a.gz"), std::nullopt);
  EXPECT_EQ(format_of_name("a.obj.gz.gz"), std::nullopt);
}

TEST(FormatOfName, IsNoneForOtherEndings) {
  EXPECT_EQ(format_of_name("-"), std::nullopt);
  EXPECT_EQ(format_of_name("mesh"), std::nullopt);
}

TEST(FormatOfContent, IsThatOfTheFirstWord) {
  EXPECT_EQ(format_of_content("# c\n\nVertex 1 0 0 0\n"), Format::Mesh);
  EXPECT_EQ(format_of_content("Face 1 1 2 3\n"), Format::Mesh);
  EXPECT_EQ(format_of_content("\nMeshVersionFormatted 1\n"), Format::Inria);
  EXPECT_EQ(format_of_content("ply\nformat ascii 1.0\n"), Format::Ply);
  EXPECT_EQ(format_of_content("CNOFF\n"), Format::Off);
  EXPECT_EQ(format_of_content("Solid a\n"), Format::Stl);
  EXPECT_EQ(format_of_content("mtllib a.mtl\n"), Format::Obj);
  EXPECT_EQ(format_of_content("v 0 0 0\n"), Format::Obj);
}

TEST(FormatOfContent, IsNoneForAnythingElse) {
  EXPECT_EQ(format_of_content(""), std::nullopt);
  EXPECT_EQ(format_of_content("hello\n"), std::nullopt);
}

TEST(FormatOf, ThatOfInriaIsKnownByItsFirstWord) {
  EXPECT_EQ(format_of("# c\nMeshVersionFormatted 2", "a.mesh"), Format::Inria);
  EXPECT_EQ(format_of("Vertex 1 0 0 0 # MeshVersionFormatted", "a.mesh"), Format::Mesh);
}

TEST(FormatOf, ContentBeyondDoubtCountsMoreThanTheName) {
  EXPECT_EQ(format_of("OFF\n", "a.stl"), Format::Off);
  EXPECT_EQ(format_of("ply\n", "a.obj"), Format::Ply);
  EXPECT_EQ(format_of("solid\n", "a.ply"), Format::Stl);
  EXPECT_EQ(format_of("v 0 0 0\n", "a.off"), Format::Obj);
  EXPECT_EQ(format_of("Vertex 1 0 0 0\n", "a.obj"), Format::Mesh);
}

TEST(FormatOf, TheNameCountsWhereTheContentMayBeAnything) {
  EXPECT_EQ(format_of("hello\n", "a.obj"), Format::Obj);
  EXPECT_EQ(format_of("p 1\n", "a.mesh"), Format::Mesh);  // a keyword of OBJ, but also a torn word
  EXPECT_EQ(format_of("3 1 2\n", "a.off"), Format::Off);
  EXPECT_EQ(format_of("", "a.ply"), Format::Ply);
}

TEST(FormatOf, AnStlFileWithZeroBytesIsBinaryWhateverItsHeaderBeginsWith) {
  EXPECT_EQ(format_of(std::string("ply made by hand\0", 17), "a.stl"), Format::Stl);
}

TEST(IsNamedAs, TheEndingOfMeshStandsForTwoFormats) {
  EXPECT_TRUE(is_named_as("a.mesh", Format::Inria));
  EXPECT_TRUE(is_named_as("a.mesh.gz", Format::Mesh));
  EXPECT_TRUE(is_named_as("-", Format::Ply));
  EXPECT_FALSE(is_named_as("a.mesh", Format::Off));
}

}  // namespace
}  // namespace meshalyzer
