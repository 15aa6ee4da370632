#include "meshalyzer/io/inria.h"

#include "io_cases.h"
#include "support/same_soup.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

const std::string kInriaHeader = "MeshVersionFormatted 2\nDimension 3\n";
const std::string kThreeVertices = "Vertices 3\n0 0 0 1\n1 0 0 1\n0 1 0 1\n";

Soup inria_soup(const std::string& text) {
  return parse_inria(text, "i.mesh");
}

TEST(ParseInria, ReadsVerticesAndTriangles) {
  const Soup soup = inria_soup(kInriaHeader + kThreeVertices + "Triangles 1\n1 2 3 7\nEnd\n");
  EXPECT_EQ(soup.format, Format::Inria);
  EXPECT_EQ(soup.positions[2], Vec3(0, 1, 0));
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(soup.vertex_ids.first, 1);
  EXPECT_EQ(soup.vertex_lines, (std::vector<std::uint32_t>{4, 5, 6}));
  EXPECT_EQ(soup.face_lines, (std::vector<std::uint32_t>{8}));
}

TEST(ParseInria, LineEndsMeanNothing) {
  const Soup soup = inria_soup(
      "# c\r\nMeshVersionFormatted\r\n1\r\nDimension\n3 Vertices\n\n3 0 0\n0 1 1 0 0 1 # c\n0 1 0 "
      "1\nTriangles\n1\n1 2 3\n0");
  EXPECT_EQ(soup.n_vertices(), 3U);
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(ParseInria, QuadrilateralsAreFanned) {
  const Soup soup =
      inria_soup(kInriaHeader +
                 "Vertices 4\n0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0\nQuadrilaterals 1\n1 2 3 4 0\nEnd\n");
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(soup.n_polygons, 1U);
}

TEST(ParseInria, OtherSectionsAreSkipped) {
  const Soup soup = inria_soup(
      kInriaHeader + "Identifier \"a b\"\n" + kThreeVertices +
      "Edges 2\n1 2 0\n2 3 0\nCorners\n2\n1\n2\nRidges 1\n1\nRequiredVertices 1\n3\n"
      "Normals 1\n0 0 nan\nNormalAtVertices 1\n1 1\nTangents 1 1 0 0\nTangentAtVertices 1 1 1\n"
      "Tetrahedra 1\n1 2 3 3 0\nHexahedra 0\nAngleOfCornerBound 30.5\n"
      "Triangles 1\n1 2 3 7\nEnd\nwhat follows is not read");
  EXPECT_EQ(soup.n_vertices(), 3U);
  EXPECT_EQ(soup.n_faces(), 1U);
}

TEST(ParseInria, AnIndexBeyondTheVerticesIsMissing) {
  const Soup soup = inria_soup(kInriaHeader + "Triangles 1\n1 2 4 0\n" + kThreeVertices);
  ASSERT_EQ(soup.missing.size(), 1U);
  EXPECT_EQ(soup.missing[0].id, 4);
}

TEST(ParseInria, RefusesWhatIsMalformedAtItsLine) {
  const std::vector<RefusedText> cases = {
      {"Dimension 3\n", "i.mesh:1: the keyword MeshVersionFormatted"},
      {"MeshVersionFormatted\n", "i.mesh:2: the file ends before its version"},
      {"MeshVersionFormatted 2\nDimension 2\n", "i.mesh:2: only meshes of dimension 3"},
      {kInriaHeader + "Vertexes 3\n", "i.mesh:3: \"Vertexes\" is no keyword"},
      {kInriaHeader + "Vertices 3\n0 0 0 1\n1 0 0 1\n",
       "i.mesh:3: a count of 3 vertices, but only"},
      {kInriaHeader + "Vertices 3\n0.00 0.00 0.00 1\n1 0 0 1\n",
       "i.mesh:6: the file ends before vertex 3 of 3"},
      {kInriaHeader + "Vertices 4000000000\n0 0 0 1\n",
       "i.mesh:3: a count of 4000000000 vertices, but only"},
      {kInriaHeader + "Vertices -1\n", "i.mesh:3: a count of -1 vertices"},
      {kInriaHeader + "Vertices 1\n0 0 nan 1\n", "i.mesh:4: \"nan\" is not a finite number"},
      {kInriaHeader + "Vertices 1\n0 0 x 1\n", "i.mesh:4: \"x\" is not a number"},
      {kInriaHeader + kThreeVertices + kThreeVertices, "i.mesh:7: a second section"},
      {kInriaHeader + kThreeVertices + "Triangles 1\n0 1 2 0\n",
       "i.mesh:8: index 0: indices count from 1"},
      {kInriaHeader + kThreeVertices + "Triangles 1\n1 2 3000000000 0\n",
       "i.mesh:8: index 3000000000 is beyond"},
      {kInriaHeader + kThreeVertices + "Triangles 1\n1 2 3 0\n1 2 3 0\nEnd\n",
       "i.mesh:9: \"1\" is no keyword"},
      {kInriaHeader + kThreeVertices + "Edges 1\n1 a 0\nEnd\n", "i.mesh:8: \"a\" is not a number"},
  };
  for (const auto& [text, begin] : cases) {
    EXPECT_EQ(begin_like(error_of([&] { return inria_soup(text); }), begin), begin) << text;
  }
}

TEST(PrintInria, ReadsBackToTheLastBit) {
  Soup soup = strip_of_hard_numbers(500);
  soup.format = Format::Inria;
  EXPECT_TRUE(same_soup(inria_soup(print_inria(soup)), soup));
}

}  // namespace
}  // namespace meshalyzer
