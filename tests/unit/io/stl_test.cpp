#include "meshalyzer/io/stl.h"

#include "io_cases.h"
#include "meshalyzer/base/bytes.h"
#include "support/same_soup.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 1\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c +
         "\n endloop\nendfacet\n";
}

/// Two facets of a unit square: lines 2 and 9 of a file whose first line is `solid`.
std::string two_facets() {
  return facet("0 0 0", "1 0 0", "1 1 0") + facet("0 0 0", "1 1 0", "0 1 0");
}

/// A binary file of one facet per nine coordinates, with a header that begins like ASCII does.
std::string binary(const std::vector<float>& coordinates) {
  std::string content = "solid of some name";
  content.resize(80, ' ');
  append_little_endian(content, static_cast<std::uint32_t>(coordinates.size() / 9));
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    content.append(i % 9 == 0 ? 12 : 0, '\0');
    append_little_endian(content, coordinates[i]);
    content.append(i % 9 == 8 ? 2 : 0, '\0');
  }
  return content;
}

Soup stl_soup(const std::string& content) {
  return parse_stl(content, "s.stl");
}

TEST(ParseStl, EqualPointsOfAsciiBecomeOneVertex) {
  const Soup soup = stl_soup("solid square\n" + two_facets() + "endsolid square\n");
  EXPECT_EQ(soup.format, Format::Stl);
  EXPECT_EQ(soup.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(soup.n_merged_points, 2U);
  EXPECT_EQ(soup.vertex_ids.first, 1);
  EXPECT_EQ(soup.face_lines, (std::vector<std::uint32_t>{2, 9}));
  EXPECT_EQ(soup.vertex_lines, (std::vector<std::uint32_t>{4, 5, 6, 13}));
}

TEST(ParseStl, ZeroAndMinusZeroAreOnePlaceAndTheFirstIsKept) {
  const Soup soup = stl_soup("solid\n" + facet("-0 0 0", "0 -0.0 0", "0 0 1") + "endsolid\n");
  EXPECT_EQ(soup.n_vertices(), 2U);
  EXPECT_TRUE(std::signbit(soup.positions[0].x()));
  EXPECT_EQ(soup.triangles[0], (Triangle{0, 0, 1}));
}

TEST(ParseStl, PointsThatDifferInTheLastBitStayTwo) {
  EXPECT_EQ(
      stl_soup("solid\n" + facet("0.1 0 0", "0.10000000000000002 0 0", "0 0 1") + "endsolid\n")
          .n_vertices(),
      3U);
}

TEST(ParseStl, ManyPointsKeepTheirOrder) {
  std::vector<float> coordinates;
  for (int i = 0; i < 9000; ++i) {
    coordinates.push_back(static_cast<float>(i));
  }
  const Soup soup = stl_soup(binary(coordinates));
  ASSERT_EQ(soup.n_vertices(), 3000U);
  EXPECT_EQ(soup.positions[2999], Vec3(8997, 8998, 8999));
  EXPECT_EQ(soup.triangles[999], (Triangle{2997, 2998, 2999}));
}

TEST(ParseStl, KeywordsMayBeInAnyCaseAndSolidsMany) {
  const Soup soup = stl_soup(
      "SOLID the first # one\nFACET NORMAL nan nan nan OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0\r\n"
      "VERTEX 0 1 0 ENDLOOP ENDFACET\nENDSOLID the first\n\nSolid\n" +
      two_facets() + "EndSolid");
  EXPECT_EQ(soup.n_faces(), 3U);
  EXPECT_EQ(soup.n_vertices(), 4U);
}

TEST(ParseStl, BinaryIsKnownByItsSizeThoughItBeginsWithSolid) {
  const Soup soup = stl_soup(binary({0, 0, 0, 1, 0, 0, 0, 0.1F, 0}));
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(soup.positions[2], Vec3(0, static_cast<double>(0.1F), 0));
  EXPECT_TRUE(soup.face_lines.empty());
}

TEST(ParseStl, RefusesWhatIsMalformedAtItsLine) {
  const std::string begin_facet =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  const std::vector<RefusedText> cases = {
      {"sold\n", "s.stl:1: \"sold\" stands where solid should"},
      {"\n", "s.stl:2: the file ends before the keyword solid"},
      {"solid a\n", "s.stl:2: the file ends before endsolid"},
      {"solid a\n" + two_facets(), "s.stl:16: the file ends before endsolid"},
      {"solid a\nfacet\n", "s.stl:3: the file ends before normal"},
      {"solid a\nfacet normal 0 0 x\n", "s.stl:2: \"x\" is not a number"},
      {"solid a\nfacets\n", "s.stl:2: \"facets\" stands where facet should"},
      {begin_facet, "s.stl:6: the file ends before vertex"},
      {begin_facet + "vertex 0 1\nendloop\n", "s.stl:7: \"endloop\" is not a number"},
      {begin_facet + "vertex 0 1 nan\nendloop\n", "s.stl:6: \"nan\" is not a finite number"},
      {begin_facet + "endloop\n", "s.stl:6: \"endloop\" stands where vertex should"},
      {begin_facet + "vertex 0 1 0\nvertex 0 0 1\nendloop\n",
       "s.stl:7: \"vertex\" stands where endloop should"},
      {"solid a\n" + two_facets() + "endsolid a\nmore\n",
       "s.stl:17: \"more\" stands where solid should"},
  };
  for (const auto& [text, begin] : cases) {
    EXPECT_EQ(begin_like(error_of([&] { return stl_soup(text); }), begin), begin) << text;
  }
}

TEST(ParseStl, RefusesBinaryThatIsMalformedAtItsByte) {
  const std::string good = binary({0, 0, 0, 1, 0, 0, 0, 1, 0});
  std::string many = good;
  many.replace(80, 4, "\xff\xff\xff\xff");
  const std::vector<RefusedText> cases = {
      {good.substr(0, 133),
       "s.stl:byte 80: a count of 1 facets, which take 134 bytes, but the file has 133"},
      {good + "x", "s.stl:byte 80: a count of 1 facets"},
      {many, "s.stl:byte 80: a count of 4294967295 facets"},
      {good.substr(0, 80) + std::string(4, '\0'), "s.stl:byte 80: no mesh in it"},
      {std::string(10, '\0'), "s.stl:byte 10: the file ends within"},
      {binary({0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::infinity(), 0}),
       "s.stl:byte 120: a coordinate is not a finite number"},  // 84 + 12 + 2 * 12
  };
  for (const auto& [content, begin] : cases) {
    EXPECT_EQ(begin_like(error_of([&] { return stl_soup(content); }), begin), begin);
  }
}

TEST(PrintAsciiStl, ReadsBackToTheLastBit) {
  Soup soup = strip_of_hard_numbers(500);
  soup.format = Format::Stl;
  EXPECT_TRUE(same_soup(stl_soup(print_ascii_stl(soup)), soup));
}

TEST(PrintAsciiStl, FacetsHaveTheirUnitNormal) {
  Soup soup;
  soup.positions = {{0, 0, 0}, {0, 1e-200, 0}, {0, 0, 1e200}};
  soup.triangles = {{0, 1, 2}, {0, 1, 1}};
  const std::string text = print_ascii_stl(soup);
  EXPECT_NE(text.find("facet normal 1 0 0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("facet normal 0 0 0\n"), std::string::npos) << text;
}

TEST(PrintBinaryStl, FloatsReadBackToTheLastBit) {
  const std::string content = binary({0, 0, 0, 1, 0.1F, 1e-45F, 0, 3e38F, -7});
  const Soup soup = stl_soup(content);
  EXPECT_TRUE(same_soup(stl_soup(print_binary_stl(soup)), soup));
}

TEST(PrintBinaryStl, RefusesWhatNoFloatCanHold) {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1e39, 0, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}};
  EXPECT_THROW(static_cast<void>(print_binary_stl(soup)), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
