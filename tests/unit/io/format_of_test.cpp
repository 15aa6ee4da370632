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

TEST(FormatOfName, IsNoneForOtherEndings) {
  EXPECT_EQ(format_of_name("-"), std::nullopt);
  EXPECT_EQ(format_of_name("mesh"), std::nullopt);
  EXPECT_EQ(format_of_name("a.mesh.gz"), std::nullopt);
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

TEST(IsInria, LooksAtTheFirstWord) {
  EXPECT_TRUE(is_inria("# c\nMeshVersionFormatted 2"));
  EXPECT_FALSE(is_inria("Vertex 1 0 0 0 # MeshVersionFormatted"));
}

}  // namespace
}  // namespace meshalyzer
