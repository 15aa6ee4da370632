#include "meshalyzer/io/rewrite/rewrite.h"
#include "meshalyzer/io/write.h"
#include "support/edited_file.h"

#include <gtest/gtest.h>

#include <string>

namespace meshalyzer {
namespace {

TEST(RewriteStl, FacetsStayInTheirSolids) {
  const std::string facet =
      " facet normal 0 0 1\n  outer loop\n   vertex 0.0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n"
      "  endloop\n endfacet\n";
  const std::string text = "solid a\n" + facet + "endsolid a\nsolid b\n" +
                           with(facet, "0 1 0", "0 -1 0") + "endsolid b\n";
  EditedFile file(text, "a.stl");
  EXPECT_EQ(file.rewritten_bytes(), text);
  file.add_face({0, 2, 1}, beside(0));
  const std::string added = with(with(with(facet, "0 0 1", "0 0 -1"), "1 0 0", "0 1 0"),
                                 "   vertex 0 1 0\n  endloop", "   vertex 1 0 0\n  endloop");
  EXPECT_EQ(file.rewritten_bytes(), with(text, "endsolid a", added + "endsolid a"));
  file.drop_face(0);
  EXPECT_EQ(file.read_back().n_faces(), 2u);
}

TEST(RewriteStl, CoordinatesThatStayKeepTheirWords) {
  const std::string text =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0.0 +0 0e0\nvertex 1.0 0.0 0\nvertex 0 1.00 "
      "0\n"
      "endloop\nendfacet\nendsolid\n";
  EditedFile moved(text, "a.stl");
  moved.soup().positions[2] = {0, 2, 0};
  EXPECT_EQ(moved.rewritten_bytes(), with(text, "vertex 0 1.00 0", "vertex 0 2 0"));
  EditedFile turned(text, "a.stl");
  turned.soup().triangles[0] = {1, 0, 2};
  EXPECT_EQ(turned.rewritten_bytes(),
            with(with(text, "normal 0 0 1", "normal 0 0 -1"), "vertex 0.0 +0 0e0\nvertex 1.0 0.0 0",
                 "vertex 1.0 0.0 0\nvertex 0.0 +0 0e0"));
}

/// Two facets with comments in them and behind them.
std::string commented_stl() {
  const std::string first =
      "facet normal 0 0 1 # a\r\nouter loop\r\n# b\r\nvertex 0 0 0\r\nvertex 1 0 0\r\n"
      "vertex 0 1 0\r\nendloop\r\nendfacet # c\r\n";
  return "solid s\r\n" + first + with(with(first, "# a", "# d"), "0 1 0", "0 -1 0") +
         "endsolid\r\n";
}

TEST(RewriteStl, CommentsInADroppedFacetAreCountedAsLost) {
  EditedFile file(commented_stl(), "a.stl");
  file.drop_face(0);
  EXPECT_EQ(attribute_text(file.rewritten()->lost.at(0)), "2 comments");
  EXPECT_EQ(file.rewritten_bytes().find("# a"), std::string::npos);
}

TEST(RewriteStl, CommentsOfAFacetAreNotCopied) {
  EditedFile file(commented_stl(), "a.stl");
  file.add_face({0, 2, 1}, beside(1));
  EXPECT_EQ(file.rewritten_bytes(),
            with(commented_stl(), "endfacet # c\r\nendsolid",
                 "endfacet\r\nfacet normal 0 0 -1\r\nouter loop\r\n\r\nvertex 0 0 0\r\n"
                 "vertex 0 1 0\r\nvertex 1 0 0\r\nendloop\r\nendfacet # c\r\nendsolid"));
}

TEST(RewriteStl, CommentsStayInTheFirstFacetThatIsMadeOfAnother) {
  EditedFile file(commented_stl(), "a.stl");
  file.add_vertex({0.5, 0, 0});
  file.add_face({0, 4, 2}, made_of(0));
  file.add_face({4, 1, 2}, made_of(0));
  file.drop_face(0);
  EXPECT_TRUE(file.rewritten()->lost.empty());
  const std::string bytes = file.rewritten_bytes();
  EXPECT_NE(bytes.find("# a"), std::string::npos);
  EXPECT_EQ(bytes.find("# a"), bytes.rfind("# a"));
}

TEST(RewriteStl, BinaryKeepsHeaderAndAttributeWords) {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.triangles = {{0, 1, 2}, {0, 1, 3}};
  std::string bytes = print_mesh(soup, Format::Stl, Encoding::Binary);
  bytes.replace(0, 4, "mine");
  bytes[84 + 48] = 7;
  EditedFile file(bytes, "a.stl");
  EXPECT_EQ(file.rewritten_bytes(), bytes);
  file.add_face({1, 2, 3}, made_of(0));
  file.add_face({2, 0, 3}, beside(0));
  const std::string after = file.rewritten_bytes();
  EXPECT_EQ(after.substr(0, 80), bytes.substr(0, 80));
  EXPECT_EQ(after.substr(84, 100), bytes.substr(84));
  EXPECT_EQ(after[84 + 148], 7);
  EXPECT_EQ(after[84 + 198], 0);
}

TEST(RewriteStl, BinaryCannotHoldWhatIsNoFloat) {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}};
  EditedFile file(print_mesh(soup, Format::Stl, Encoding::Binary), "a.stl");
  file.soup().positions[1].x() = 0.1;
  EXPECT_FALSE(file.rewritten());
}

}  // namespace
}  // namespace meshalyzer
