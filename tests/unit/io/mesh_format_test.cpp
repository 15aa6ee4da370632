#include "meshalyzer/io/mesh_format.h"

#include "io_cases.h"
#include "meshalyzer/base/parallel.h"
#include "support/same_soup.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

Soup mesh_soup(const std::string& text) {
  return parse_mesh_format(text, "m.mesh");
}

TEST(ParseMeshFormat, ReadsVerticesAndFaces) {
  const Soup soup = mesh_soup("Vertex 1 0 0.5 -1\nVertex 2 1 0 0\nVertex 3 0 1 0\nFace 1 1 2 3\n");
  EXPECT_EQ(soup.format, Format::Mesh);
  EXPECT_EQ(soup.positions[0], Vec3(0, 0.5, -1));
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(soup.vertex_lines, (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(soup.face_lines, (std::vector<std::uint32_t>{4}));
}

TEST(ParseMeshFormat, FacesMayStandBeforeTheirVertices) {
  const Soup soup = mesh_soup("Face 1 3 2 1\nVertex 1 0 0 0\nVertex 2 1 0 0\nVertex 3 0 1 0\n");
  EXPECT_EQ(soup.triangles[0], (Triangle{2, 1, 0}));
  EXPECT_TRUE(soup.missing.empty());
}

TEST(ParseMeshFormat, CommentsBlankLinesAndWindowsLineEndsMeanNothing) {
  const Soup soup = mesh_soup(
      "# head\r\n\r\n \tVertex\t7  1e2 +2.5E-1 .5 # tail\r\n#Vertex\r\nVertex 8 1 2 3#x\r\n");
  ASSERT_EQ(soup.n_vertices(), 2U);
  EXPECT_EQ(soup.positions[0], Vec3(100, 0.25, 0.5));
  EXPECT_EQ(soup.vertex_lines, (std::vector<std::uint32_t>{3, 5}));
  EXPECT_EQ(soup.vertex_ids.of(1), 8);
}

TEST(ParseMeshFormat, TheLastLineNeedsNoEnd) {
  EXPECT_EQ(mesh_soup("Vertex 1 2 3 45").positions[0], Vec3(2, 3, 45));
}

TEST(ParseMeshFormat, IdsAreTheFilesOwn) {
  const Soup soup = mesh_soup(
      "Vertex 30 0 0 0\nVertex 10 0 0 0\nVertex 20 0 0 0\nFace 5 10 20 30\nFace 4 30 20 10\n");
  EXPECT_EQ(soup.vertex_ids.named, (std::vector<std::int32_t>{30, 10, 20}));
  EXPECT_EQ(soup.face_ids.named, (std::vector<std::int32_t>{5, 4}));
  EXPECT_EQ(soup.triangles[0], (Triangle{1, 2, 0}));
}

TEST(ParseMeshFormat, AnUndefinedIdIsAMissingVertexNotAnError) {
  const Soup soup = mesh_soup("Vertex 1 0 0 0\nFace 9 1 2147483647 1\n");
  ASSERT_EQ(soup.missing.size(), 1U);
  EXPECT_EQ(soup.missing[0].id, 2147483647);
  EXPECT_EQ(soup.triangles[0], (Triangle{0, kNoIndex, 0}));
}

TEST(ParseMeshFormat, EveryRecordOfADuplicateIdIsKept) {
  const Soup soup = mesh_soup("Vertex 1 0 0 0\nVertex 1 5 5 5\nFace 1 1 1 1\nFace 1 1 1 1\n");
  EXPECT_EQ(soup.n_vertices(), 2U);
  EXPECT_EQ(soup.n_faces(), 2U);
  EXPECT_EQ(soup.triangles[0], (Triangle{0, 0, 0}));
}

TEST(ParseMeshFormat, ATornLineIsNamedAndNoRecord) {
  const Soup soup = mesh_soup("Vertex 1 0 0 0\n.69 2951.15 5700\nVertex 3 0 0 0\n");
  EXPECT_EQ(soup.n_vertices(), 2U);
  EXPECT_EQ(soup.torn_lines, (std::vector<std::uint32_t>{2}));
}

TEST(ParseMeshFormat, RefusesWhatIsMalformedAtItsLine) {
  const std::vector<RefusedText> cases = {
      {"Vertex 1 0 0 0\nvertex 2 0 0 0\n", "m.mesh:2: \"vertex\" is neither Vertex nor Face"},
      {"Vertex 1 0 0 0\nEdge 1 2\n", "m.mesh:2: \"Edge\" is neither Vertex nor Face"},
      {"Vertexx 1 0 0 0\n", "m.mesh:1: \"Vertexx\""},
      {"Vertex1 0 0 0\n", "m.mesh:1: \"Vertex1\""},
      {"Vertex 1 0 0\n", "m.mesh:1: the line ends where a number should stand"},
      {"Vertex 1 0 0 # 0\n", "m.mesh:1: the line ends where a number should stand"},
      {"Vertex 1 0 0\n0\n", "m.mesh:1: the line ends where a number should stand"},
      {"Vertex\n", "m.mesh:1: the line ends where an integer should stand"},
      {"\n\nVertex 1 0 0 0 0\n", "m.mesh:3: \"0\" stands where the line should end"},
      {"Face 1 1 2\n", "m.mesh:1: the line ends where an integer should stand"},
      {"Face 1 1 2 3 4\n", "m.mesh:1: \"4\" stands where the line should end"},
      {"Vertex 1 0 x 0\n", "m.mesh:1: \"x\" is not a number"},
      {"Vertex 1 0 1,5 0\n", "m.mesh:1: \"1,5\" is not a number"},
      {"Vertex 1 0 1.5.2 0\n", "m.mesh:1: \"1.5.2\" is not a number"},
      {"Vertex 1 0 1e 0\n", "m.mesh:1: \"1e\" is not a number"},
      {"Vertex 1 0 0x10 0\n", "m.mesh:1: \"0x10\" is not a number"},
      {"Vertex 1 0 nan 0\n", "m.mesh:1: \"nan\" is not a finite number"},
      {"Vertex 1 0 -inf 0\n", "m.mesh:1: \"-inf\" is not a finite number"},
      {"Vertex 1 0 1e999 0\n", "m.mesh:1: \"1e999\" is not a finite number"},
      {"Vertex 0 0 0 0\n", "m.mesh:1: index 0: indices count from 1"},
      {"Vertex -4 0 0 0\n", "m.mesh:1: index -4: indices count from 1"},
      {"Vertex 2147483648 0 0 0\n", "m.mesh:1: index 2147483648 is beyond 2147483647"},
      {"Vertex 99999999999999999999 0 0 0\n", "m.mesh:1: \"99999999999999999999\" is too large"},
      {"Vertex 1.5 0 0 0\n", "m.mesh:1: \"1.5\" is not an integer"},
      {"Face 1 1 2 0\n", "m.mesh:1: index 0"},
      {"Face 1 1 2 -3\n", "m.mesh:1: index -3"},
      {"Face 1 1 2 3.0\n", "m.mesh:1: \"3.0\" is not an integer"},
      {std::string("\x7f\x45LF\x02\x00\x00", 7),
       "m.mesh:1: \"\\x7fELF\\x02\\x00\\x00\" is neither"},
  };
  for (const auto& [text, begin] : cases) {
    EXPECT_EQ(begin_like(error_of([&] { return mesh_soup(text); }), begin), begin) << text;
  }
}

TEST(ParseMeshFormat, TheSizeOfThePartsChangesNothing) {
  const std::string text =
      print_mesh_format(strip_of_hard_numbers(300)) + "# end\r\n12 torn\nFace 900 1 2 9999\n";
  const Soup whole = parse_mesh_format(text, "m.mesh");
  for (const std::size_t bytes : {1U, 7U, 64U, 1000U, 1U << 20U}) {
    const Soup parts = parse_mesh_format(text, "m.mesh", {.bytes_per_part = bytes});
    EXPECT_TRUE(same_soup(parts, whole)) << bytes;
    EXPECT_EQ(parts.vertex_lines, whole.vertex_lines) << bytes;
    EXPECT_EQ(parts.face_lines, whole.face_lines) << bytes;
    EXPECT_EQ(parts.torn_lines, whole.torn_lines) << bytes;
    EXPECT_EQ(parts.missing.size(), whole.missing.size()) << bytes;
  }
}

TEST(ParseMeshFormat, TheFirstFaultIsToldWhateverThePartsAndThreads) {
  std::string text;
  for (int i = 1; i <= 1000; ++i) {
    text += i % 300 == 0 ? "Vertex bad\n" : "Vertex " + std::to_string(i) + " 0 0 0\n";
  }
  for (const std::size_t threads : {1U, 4U}) {
    const ThreadLimit limit(threads);
    for (const std::size_t bytes : {1U, 100U, 1U << 20U}) {
      const auto call = [&] {
        return parse_mesh_format(text, "m.mesh", {.bytes_per_part = bytes});
      };
      EXPECT_EQ(error_of(call), "m.mesh:300: \"bad\" is not an integer");
    }
  }
}

TEST(PrintMeshFormat, ReadsBackToTheLastBit) {
  const Soup soup = strip_of_hard_numbers(2000);
  EXPECT_TRUE(same_soup(mesh_soup(print_mesh_format(soup)), soup));
}

TEST(PrintMeshFormat, KeepsTheFilesOwnIds) {
  const std::string text =
      "Vertex 30 0 0 0\nVertex 10 1 0 0\nVertex 20 0 1.5 0\nFace 8 10 20 30\nFace 4 30 30 10\n";
  EXPECT_EQ(print_mesh_format(mesh_soup(text)), text);
}

TEST(PrintMeshFormat, IdsFromZeroAreMovedToOne) {
  Soup soup = strip_of_hard_numbers(3);
  soup.vertex_ids.first = 0;
  soup.face_ids.first = 0;
  EXPECT_NE(print_mesh_format(soup).find("\nFace 1 1 2 3\n"), std::string::npos);
}

TEST(PrintMeshFormat, AMissingVertexCannotBeWritten) {
  const Soup soup = mesh_soup("Vertex 1 0 0 0\nFace 9 1 2 1\n");
  EXPECT_THROW(static_cast<void>(print_mesh_format(soup)), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
