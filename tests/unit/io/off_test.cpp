#include "meshalyzer/io/off.h"

#include "io_cases.h"
#include "support/same_soup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

const std::string kFourPoints = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Soup off_soup(const std::string& text) {
  return parse_off(text, "f.off");
}

TEST(ParseOff, ReadsVerticesAndFaces) {
  const Soup soup = off_soup("OFF\n4 2 5\n" + kFourPoints + "3 0 1 2\n3  0 2 3\n");
  EXPECT_EQ(soup.format, Format::Off);
  EXPECT_EQ(soup.positions[2], Vec3(1, 1, 0));
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(soup.vertex_ids.first, 0);
  EXPECT_EQ(soup.face_ids.first, 0);
  EXPECT_EQ(soup.vertex_lines.front(), 3U);
  EXPECT_EQ(soup.face_lines, (std::vector<std::uint32_t>{7, 8}));
}

TEST(ParseOff, EveryFormOfTheHeaderIsRead) {
  for (const char* header : {"OFF\n4 1 0\n", "OFF 4 1 0\n", "OFF\n4 1\n", "4 1 0\n",
                             "# c\nOFF # c\n\n# c\n4 1 0 # c\n", "OFF\r\n4 1 0\r\n"}) {
    const Soup soup = off_soup(header + kFourPoints + "3 0 1 2\n");
    EXPECT_EQ(soup.n_vertices(), 4U) << header;
    EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}})) << header;
  }
}

TEST(ParseOff, PolygonsAreFanned) {
  const Soup soup = off_soup("OFF\n4 3 0\n" + kFourPoints + "4 0 1 2 3\n2 0 1\n1 3\n");
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 1}, {3, 3, 3}}));
  EXPECT_EQ(soup.n_polygons, 1U);
}

TEST(ParseOff, ColoursOfVerticesAndFacesAreSkipped) {
  const Soup soup = off_soup(
      "COFF\n3 4 0\n0 0 0 255 0 0 255\n1 0 0 0.1 0.2 0.3\n0 1 0 1 1 1 1 # c\n"
      "3 0 1 2 0.5 0.5 0.5\n3 0 1 2 1 2 3 4\n3 0 1 2 7\n3 0 1 2\n");
  EXPECT_EQ(soup.n_vertices(), 3U);
  EXPECT_EQ(soup.n_faces(), 4U);
}

TEST(ParseOff, NormalsOfVerticesAreKept) {
  const Soup soup = off_soup(
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 9 9 9 0 0\n1 0 0 0 1 0 9 9 9 0 0\n0 1 0 1 0 0 9 9 9 9 0 0\n3 2 "
      "1 0\n");
  EXPECT_EQ(soup.normals, (std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
  EXPECT_EQ(soup.corner_normals, (std::vector<Triangle>{{2, 1, 0}}));
}

TEST(ParseOff, AnIndexBeyondTheVerticesIsMissing) {
  const Soup soup = off_soup("OFF\n4 1 0\n" + kFourPoints + "3 0 1 4\n");
  ASSERT_EQ(soup.missing.size(), 1U);
  EXPECT_EQ(soup.missing[0].id, 4);
  EXPECT_EQ(soup.missing[0].corner, 2);
}

TEST(ParseOff, ColoursThatAreNoNumbersAreSkippedToo) {
  EXPECT_TRUE(same_soup(off_soup("COFF\n4 1 0\n0 0 0 nan nan nan 1\n1 0 0 0 0 0 1\n1 1 0 0 0 0 1\n"
                                 "0 1 0 0 0 0 1\n3 0 1 2 nan 0 inf\n"),
                        off_soup("OFF\n4 1 0\n" + kFourPoints + "3 0 1 2\n")));
}

/// A binary file: a line, then 32-bit numbers, the most significant byte first.
class BinaryOffFile {
 public:
  explicit BinaryOffFile(std::string line) : content_(std::move(line)) {}

  BinaryOffFile& integers(const std::vector<std::int32_t>& values) {
    for (const std::int32_t value : values) {
      add(value);
    }
    return *this;
  }
  BinaryOffFile& floats(const std::vector<float>& values) {
    for (const float value : values) {
      add(value);
    }
    return *this;
  }
  [[nodiscard]] const std::string& content() const { return content_; }

 private:
  template <typename T>
  void add(T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (std::endian::native == std::endian::little) {
      std::reverse(bytes.begin(), bytes.end());
    }
    content_.append(bytes.data(), bytes.size());
  }

  std::string content_;
};

/// The square of kFourPoints, its two faces, one of which has a colour.
BinaryOffFile binary_square() {
  BinaryOffFile file("OFF BINARY\n");
  file.integers({4, 2, 0}).floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  file.integers({3, 0, 1, 2, 0}).integers({3, 0, 2, 3, 3}).floats({1, 0.5F, 0});
  return file;
}

TEST(ParseOff, BinaryIsTheSameMeshAsText) {
  const Soup soup = off_soup(binary_square().content());
  EXPECT_TRUE(same_soup(soup, off_soup("OFF\n4 2 0\n" + kFourPoints + "3 0 1 2\n3 0 2 3\n")));
  EXPECT_TRUE(soup.vertex_lines.empty());
  EXPECT_TRUE(soup.face_lines.empty());
}

TEST(ParseOff, BinaryHasNormalsColoursAndTexturesAsItsKeywordSays) {
  BinaryOffFile file("STCNOFF BINARY\n");
  file.integers({1, 0, 0}).floats({1, 2, 3, 0, 0, 1, 0.1F, 0.2F, 0.3F, 1, 0.5F, 0.5F});
  const Soup soup = off_soup(file.content());
  EXPECT_EQ(soup.positions, (std::vector<Vec3>{{1, 2, 3}}));
  EXPECT_EQ(soup.normals, (std::vector<Vec3>{{0, 0, 1}}));
}

TEST(ParseOff, EveryCutOfABinaryFileIsRefusedAtAByte) {
  const std::string content = binary_square().content();
  for (std::size_t n = std::string("OFF BINARY\n").size(); n < content.size(); ++n) {
    EXPECT_EQ(begin_like(error_of([&] { return off_soup(content.substr(0, n)); }), "f.off:byte "),
              "f.off:byte ")
        << n;
  }
}

TEST(ParseOff, RefusesBinaryContentThatIsMalformedAtItsByte) {
  const auto file = [](const std::vector<std::int32_t>& numbers) {
    return BinaryOffFile("OFF BINARY\n").integers(numbers).content();
  };
  constexpr std::int32_t kNan = 0x7fc00000;
  const std::vector<RefusedText> cases = {
      {file({2000000000, 1, 0}), "f.off:byte 11: a count of 2000000000 vertices, but only"},
      {file({-1, 1, 0}), "f.off:byte 11: a count of -1 vertices"},
      {file({1, 2000000000, 0, 0, 0, 0}), "f.off:byte 15: a count of 2000000000 faces"},
      {file({1, 0, 0, 0, kNan, 0}), "f.off:byte 27: a number is not finite"},
      {file({1, 1, 0, 0, 0, 0, 0, 0, 0}), "f.off:byte 35: a face without corners"},
      {file({1, 1, 0, 0, 0, 0, 1, -1, 0}), "f.off:byte 39: index -1"},
      {file({1, 1, 0, 0, 0, 0, 1, 0, 9}), "f.off:byte 43: a count of 9 colour components"},
      {file({1, 0, 0, 0, 0, 0, 7}), "f.off:byte 35: 4 bytes more than the header counts"},
  };
  for (const auto& [content, begin] : cases) {
    EXPECT_EQ(begin_like(error_of([&] { return off_soup(content); }), begin), begin);
  }
}

TEST(ParseOff, RefusesWhatIsMalformedAtItsLine) {
  const std::vector<RefusedText> cases = {
      {"OOF\n4 1 0\n", "f.off:1: \"OOF\" is not the keyword OFF"},
      {"OFF\n", "f.off:2: the file ends before its counts"},
      {"OFF BINARY\n", "f.off:byte 11: the file ends within a record"},
      {"OFF BINARY now\n", "f.off:1: \"now\" stands where the line should end"},
      {"4OFF BINARY\n", "f.off:1: OFF in other than"},
      {"4OFF\n1 0 0\n0 0 0 1\n", "f.off:1: OFF in other than"},
      {"nOFF\n3\n1 0 0\n0 0 0\n", "f.off:1: OFF in other than"},
      {"OFF\n4\n", "f.off:2: a count of 4 vertices, but only 1 bytes follow"},
      {"OFF\n1 x\n0 0 0\n", "f.off:2: \"x\" is not an integer"},
      {"OFF\n4 1 0 0\n" + kFourPoints + "3 0 1 2\n",
       "f.off:2: \"0\" stands where the line should end"},
      {"OFF\n-1 0 0\n", "f.off:2: a count of -1 vertices"},
      {"OFF\n4000000000 1 0\n" + kFourPoints, "f.off:2: a count of 4000000000 vertices, but only"},
      {"OFF\n4 4000000000 0\n" + kFourPoints, "f.off:2: a count of 4000000000 faces, but only"},
      {"OFF\n5 0 0\n" + kFourPoints + "     \n", "f.off:8: the file ends before vertex 4 of 5"},
      {"OFF\n4 2 0\n" + kFourPoints + "3 0 1 2\n", "f.off:8: the file ends before face 1 of 2"},
      {"OFF\n4 1 0\n" + kFourPoints + "3 0 1 2\n3 0 1 2\n", "f.off:8: more lines than"},
      {"OFF\n3 0 0\n0 0 0\n0 0\n0 0 0 \n", "f.off:4: the line ends where a number should stand"},
      {"OFF\n1 0 0\n0 0 0 0\n", "f.off:3: a vertex of 1 numbers beyond its position"},
      {"COFF\n1 0 0\n0 0 0\n", "f.off:3: a vertex of 0 numbers beyond its position"},
      {"NOFF\n1 0 0\n0 0 0\n", "f.off:3: the line ends where a number should stand"},
      {"OFF\n1 0 0\n0 0 inf\n", "f.off:3: \"inf\" is not a finite number"},
      {"OFF\n4 1 0\n" + kFourPoints + "0\n", "f.off:7: a face without corners"},
      {"OFF\n4 1 0\n" + kFourPoints + "3 0 1 -2\n", "f.off:7: index -2: indices count from 0"},
      {"OFF\n4 1 0\n" + kFourPoints + "3 0 1\n",
       "f.off:7: the line ends where an integer should stand"},
      {"OFF\n4 1 0\n" + kFourPoints + "3 0 1 2 9 9\n", "f.off:7: 2 numbers after the corners"},
      {"OFF\n4 1 0\n" + kFourPoints + "3 0 1 3000000000\n", "f.off:7: index 3000000000 is beyond"},
      {"OFF\n4 1 0\n" + kFourPoints + "4000000000 0 1 2\n",
       "f.off:7: a count of 4000000000 corners"},
  };
  for (const auto& [text, begin] : cases) {
    EXPECT_EQ(begin_like(error_of([&] { return off_soup(text); }), begin), begin) << text;
  }
}

TEST(PrintOff, ReadsBackToTheLastBit) {
  Soup soup = strip_of_hard_numbers(500);
  soup.format = Format::Off;
  soup.vertex_ids.first = 0;
  soup.face_ids.first = 0;
  EXPECT_TRUE(same_soup(off_soup(print_off(soup)), soup));
  soup.normals = soup.positions;
  soup.corner_normals = soup.triangles;
  EXPECT_TRUE(same_soup(off_soup(print_off(soup)), soup));
}

}  // namespace
}  // namespace meshalyzer
