#include "meshalyzer/io/ply.h"

#include "io_cases.h"
#include "meshalyzer/base/bytes.h"
#include "support/same_soup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

const std::string kVertexHeader =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFaceHeader =
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kAscii = "ply\nformat ascii 1.0\n";
const std::string kPlyHeader = kAscii + kVertexHeader + kFaceHeader;  // nine lines
const std::string kThreePoints = "0 0 0\n1 0 0\n0 1 0\n";

Soup ply_soup(const std::string& content) {
  return parse_ply(content, "p.ply");
}

/// A binary file in the given byte order with every type, an element to skip, lists to skip and
/// normals.
class BinaryFile {
 public:
  explicit BinaryFile(std::endian order) : order_(order) {
    content_ = "ply\r\nformat binary_";
    content_ += order == std::endian::little ? "little" : "big";
    content_ +=
        "_endian 1.0\r\ncomment end_header\r\nobj_info made by hand\r\nelement camera "
        "1\r\nproperty short id\r\n"
        "property list ushort char name\r\nelement face 2\r\nproperty uchar red\r\n"
        "property list uint ushort vertex_index\r\nproperty list uchar float texcoord\r\nelement "
        "vertex 4\r\n"
        "property double z\r\nproperty int x\r\nproperty uint8 quality\r\nproperty int8 y\r\n"
        "property float32 nx\r\nproperty float64 ny\r\nproperty uint nz\r\nend_header\r\n";
    n_header_bytes_ = content_.size();
  }
  template <typename T>
  BinaryFile& add(T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (order_ != std::endian::native) {
      std::reverse(bytes.begin(), bytes.end());
    }
    content_.append(bytes.data(), bytes.size());
    return *this;
  }
  void add_body() {
    add(std::int16_t{-2}).add(std::uint16_t{3}).add('a').add('b').add('\n');
    add(std::uint8_t{9}).add(std::uint32_t{4});
    for (std::uint16_t corner = 0; corner < 4; ++corner) {
      add(corner);
    }
    add(std::uint8_t{2}).add(0.5F).add(0.5F);
    add(std::uint8_t{9}).add(std::uint32_t{3});
    add(std::uint16_t{3}).add(std::uint16_t{7}).add(std::uint16_t{0});
    add(std::uint8_t{0});
    for (std::int32_t i = 0; i < 4; ++i) {
      add(0.1 * i).add(-100000 * i).add(std::uint8_t{200}).add(static_cast<std::int8_t>(-i));
      add(0.25F).add(0.5).add(std::uint32_t{4000000000U});
    }
  }
  [[nodiscard]] const std::string& content() const { return content_; }
  [[nodiscard]] std::size_t n_header_bytes() const { return n_header_bytes_; }

 private:
  std::endian order_;
  std::string content_;
  std::size_t n_header_bytes_ = 0;
};

TEST(ParsePly, ReadsAscii) {
  const Soup soup = ply_soup(kPlyHeader + kThreePoints + "3 0 1 2\n");
  EXPECT_EQ(soup.format, Format::Ply);
  EXPECT_EQ(soup.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(soup.vertex_ids.first, 0);
  EXPECT_EQ(soup.face_ids.first, 0);
  EXPECT_EQ(soup.vertex_lines, (std::vector<std::uint32_t>{10, 11, 12}));
  EXPECT_EQ(soup.face_lines, (std::vector<std::uint32_t>{13}));
}

TEST(ParsePly, PropertiesMayStandInAnyOrderAndBeSkipped) {
  const Soup soup = ply_soup(
      kAscii +
      "comment a\nelement vertex 2\nproperty uchar red\nproperty double z\nproperty list uchar int "
      "l\n"
      "property double y\nproperty double x\nelement user 2\nproperty int a\nelement empty "
      "4000000000\n"
      "element face 1\nproperty list uint8 uint32 vertex_index\nproperty float q\nend_header\n"
      "255 3 2 7 7 2 1\n0 6 0 5 4\n1\n2\n3 0 1 1 nan\n");
  EXPECT_EQ(soup.positions, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 1}}));
}

TEST(ParsePly, ReadsBinaryInEitherByteOrder) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    BinaryFile file(order);
    file.add_body();
    const Soup soup = ply_soup(file.content());
    ASSERT_EQ(soup.n_vertices(), 4U);
    EXPECT_EQ(soup.positions[3], Vec3(-300000, -3, 0.1 * 3));
    EXPECT_EQ(soup.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {3, kNoIndex, 0}}));
    EXPECT_EQ(soup.n_polygons, 1U);
    ASSERT_EQ(soup.missing.size(), 1U);
    EXPECT_EQ(soup.missing[0].id, 7);
    EXPECT_EQ(soup.normals[0], Vec3(0.25, 0.5, 4e9));
    EXPECT_EQ(soup.corner_normals, soup.triangles);
    EXPECT_TRUE(soup.vertex_lines.empty());
  }
}

TEST(ParsePly, PolygonsAreFanned) {
  const Soup soup =
      ply_soup(kAscii +
               "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 3\nproperty list int int vertex_indices\nend_header\n"
               "0 0 0\n5 0 0 0 0 0\n2 0 0\n1 0\n");
  EXPECT_EQ(soup.n_faces(), 5U);
  EXPECT_EQ(soup.n_polygons, 1U);
}

const std::string kFiveVertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 0 1\n";

/// The header of five vertices and a list of strips.
std::string strip_header(const std::string& encoding) {
  return "ply\nformat " + encoding +
         " 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement "
         "tristrips 1\nproperty list int int vertex_indices\nend_header\n";
}

/// Two strips: of three faces, the second of which is turned, and of one.
const std::vector<std::int32_t> kStrips = {0, 1, 2, 3, 4, -1, 4, 1, 0};

/// The same faces without strips.
Soup faces_of_strips() {
  return ply_soup(kAscii +
                  "element vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement "
                  "face 4\nproperty list uchar int vertex_indices\nend_header\n" +
                  kFiveVertices + "3 0 1 2\n3 2 1 3\n3 2 3 4\n3 4 1 0\n");
}

TEST(ParsePly, StripsAreFacesEveryOtherTurned) {
  std::string text = strip_header("ascii") + kFiveVertices + std::to_string(kStrips.size());
  for (const std::int32_t corner : kStrips) {
    text += ' ' + std::to_string(corner);
  }
  const Soup soup = ply_soup(text + '\n');
  EXPECT_TRUE(same_soup(soup, faces_of_strips()));
  EXPECT_EQ(soup.face_lines, (std::vector<std::uint32_t>{15, 15, 15, 15}));
}

TEST(ParsePly, StripsAreReadInEitherByteOrder) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const bool is_little = order == std::endian::little;
    std::string content = strip_header(is_little ? "binary_little_endian" : "binary_big_endian");
    const auto add = [&](auto value) {
      auto bytes = std::bit_cast<std::array<char, sizeof(value)>>(value);
      if (order != std::endian::native) {
        std::reverse(bytes.begin(), bytes.end());
      }
      content.append(bytes.data(), bytes.size());
    };
    for (const Vec3& position : faces_of_strips().positions) {
      for (const double coordinate : position) {
        add(static_cast<float>(coordinate));
      }
    }
    add(static_cast<std::int32_t>(kStrips.size()));
    for (const std::int32_t corner : kStrips) {
      add(corner);
    }
    EXPECT_TRUE(same_soup(ply_soup(content), faces_of_strips())) << is_little;
  }
}

TEST(ParsePly, StripsOfFewerThanThreeCornersAreNoFaces) {
  const Soup soup = ply_soup(strip_header("ascii") + kFiveVertices + "6 -1 0 1 -1 2 -1\n");
  EXPECT_EQ(soup.n_faces(), 0U);
  EXPECT_EQ(soup.n_vertices(), 5U);
}

TEST(ParsePly, RefusesOtherNegativeIndicesInStrips) {
  EXPECT_EQ(error_of([] { return ply_soup(strip_header("ascii") + kFiveVertices + "3 0 1 -2\n"); }),
            "p.ply:15: index -2: indices count from 0");
}

TEST(ParsePly, PointsWithoutFacesAreASoup) {
  EXPECT_EQ(ply_soup(kAscii + kVertexHeader + "end_header\n" + kThreePoints).n_vertices(), 3U);
}

TEST(ParsePly, RefusesAHeaderThatIsMalformedAtItsLine) {
  const std::string vertex = kAscii + kVertexHeader;
  const std::vector<RefusedText> cases = {
      {"plyx\n", "p.ply:1: the keyword ply does not stand first"},
      {"ply\n", "p.ply:2: the file ends before end_header"},
      {"ply\nformat ascii 2.0\nend_header\n", "p.ply:2: no line 'format"},
      {"ply\nformat binary 1.0\nend_header\n", "p.ply:2: no line 'format"},
      {"ply\nelement vertex 1\nend_header\n", "p.ply:2: no line 'format"},
      {kAscii + "elements vertex 1\n", "p.ply:3: \"elements\" is no keyword"},
      {kAscii + "element vertex\n", "p.ply:3: the line ends where an integer should stand"},
      {kAscii + "element vertex -1\n", "p.ply:3: a count of -1"},
      {kAscii + "element vertex 1 1\n", "p.ply:3: \"1\" stands where the line should end"},
      {kAscii + "property float x\n", "p.ply:3: a property before the first element"},
      {kAscii + "element vertex 1\nproperty real x\n", "p.ply:4: \"real\" is no type of PLY"},
      {kAscii + "element vertex 1\nproperty float\n", "p.ply:4: property \"\" has no name"},
      {kAscii + "element vertex 1\nproperty float x\nproperty float x\n",
       "p.ply:5: property \"x\" has no name or is"},
      {vertex + "element vertex 1\n",
       "p.ply:7: element \"vertex\" has no name or is declared twice"},
      {vertex + "element tristrips 1\nend_header\n", "p.ply:7: element tristrips needs one"},
      {vertex + "element tristrips 1\nproperty list uchar float vertex_indices\n",
       "p.ply:8: the vertex indices of faces"},
      {vertex + "element face 1\nproperty list float int vertex_indices\n",
       "p.ply:8: the size of a list"},
      {vertex + "element face 1\nproperty list uchar float vertex_indices\n",
       "p.ply:8: the vertex indices of faces"},
      {vertex + "element face 1\nproperty list uchar int corners\nend_header\n",
       "p.ply:7: element face needs one"},
      {kAscii + "element vertex 1\nproperty float x\nproperty float y\nend_header\n",
       "p.ply:3: element vertex needs"},
      {vertex, "p.ply:7: the file ends before end_header"},
  };
  for (const auto& [text, begin] : cases) {
    EXPECT_EQ(begin_like(error_of([&] { return ply_soup(text); }), begin), begin) << text;
  }
}

TEST(ParsePly, RefusesAnAsciiBodyThatIsMalformedAtItsLine) {
  const std::vector<RefusedText> cases = {
      {kPlyHeader + "0 0 0\n1 0 0\n0 1\n3 0 1 2\n",
       "p.ply:12: the line ends where a number should stand"},
      {kPlyHeader + "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n",
       "p.ply:11: \"0\" stands where the line should end"},
      {kPlyHeader + "0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n", "p.ply:11: \"x\" is not a number"},
      {kPlyHeader + "0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", "p.ply:11: \"inf\" is not a finite number"},
      {kPlyHeader + "0 0 0\n1 0 0.00\n\n   \n", "p.ply:14: the file ends before the last vertex"},
      {kPlyHeader + "0 0\n", "p.ply:3: a count of 3 for element vertex, but only 4 bytes follow"},
      {kPlyHeader + kThreePoints, "p.ply:13: the file ends before the last face"},
      {kPlyHeader + kThreePoints + "3 0 1\n",
       "p.ply:13: the line ends where an integer should stand"},
      {kPlyHeader + kThreePoints + "3 0 1 2 0\n",
       "p.ply:13: \"0\" stands where the line should end"},
      {kPlyHeader + kThreePoints + "3 0 1 -1\n", "p.ply:13: index -1: indices count from 0"},
      {kPlyHeader + kThreePoints + "3 0 1 2147483648\n", "p.ply:13: index 2147483648 is beyond"},
      {kPlyHeader + kThreePoints + "3 0 1 2.5\n", "p.ply:13: \"2.5\" is not an integer"},
      {kPlyHeader + kThreePoints + "0  \n", "p.ply:13: a face without corners"},
      {kPlyHeader + kThreePoints + "4000000000 0 1 2\n",
       "p.ply:13: a count of 4000000000 list items"},
      {kPlyHeader + kThreePoints + "3 0 1 2\n3 0 1 2\n",
       "p.ply:14: more lines than the header counts"},
      {kAscii + "element vertex 4000000000\nproperty float x\nproperty float y\nproperty float "
                "z\nend_header\n0 0 0\n",
       "p.ply:3: a count of 4000000000 for element vertex"},
      {kAscii +
           "element face 4000000000\nproperty list uchar int vertex_indices\nend_header\n1 0\n",
       "p.ply:3: a count of 4000000000 for element face"},
  };
  for (const auto& [text, begin] : cases) {
    EXPECT_EQ(begin_like(error_of([&] { return ply_soup(text); }), begin), begin) << text;
  }
}

TEST(ParsePly, EveryCutOfABinaryFileIsRefusedAtAByte) {
  BinaryFile file(std::endian::big);
  file.add_body();
  for (std::size_t n = file.n_header_bytes(); n < file.content().size(); ++n) {
    EXPECT_EQ(
        begin_like(error_of([&] { return ply_soup(file.content().substr(0, n)); }), "p.ply:byte "),
        "p.ply:byte ")
        << n;
  }
}

TEST(ParsePly, RefusesABinaryBodyThatIsMalformedAtItsByte) {
  const std::string header = "ply\nformat binary_little_endian 1.0\n" + kVertexHeader +
                             "element face 1\nproperty list int int vertex_indices\nend_header\n";
  const std::string at = "p.ply:byte ";
  const auto body = [](float z, std::int32_t n, std::int32_t corner) {
    std::string bytes(8, '\0');
    append_little_endian(bytes, z);
    bytes.append(24, '\0');
    append_little_endian(bytes, n);
    append_little_endian(bytes, corner);
    return bytes;
  };
  const std::size_t first = header.size();
  const std::vector<RefusedText> cases = {
      {header + body(std::numeric_limits<float>::quiet_NaN(), 1, 0),
       at + std::to_string(first + 8) + ": a number is"},
      {header + body(0, 2000000000, 0),
       at + std::to_string(first + 36) + ": a list of 2000000000 items"},
      {header + body(0, -1, 0), at + std::to_string(first + 36) + ": a list of -1 items"},
      {header + body(0, 0, 0), at + std::to_string(first + 40) + ": a face without corners"},
      {header + body(0, 1, -1), at + std::to_string(first + 40) + ": index -1 is not in 0 to"},
      {header + body(0, 1, 0) + "x",
       at + std::to_string(first + 44) + ": 1 bytes more than the header counts"},
  };
  for (const auto& [content, begin] : cases) {
    EXPECT_EQ(begin_like(error_of([&] { return ply_soup(content); }), begin), begin);
  }
  EXPECT_EQ(ply_soup(header + body(0, 1, 0) + "\n").n_faces(), 1U);
}

TEST(PrintPly, ReadsBackToTheLastBitInBothEncodings) {
  Soup soup = strip_of_hard_numbers(500);
  soup.format = Format::Ply;
  soup.vertex_ids.first = 0;
  soup.face_ids.first = 0;
  EXPECT_TRUE(same_soup(ply_soup(print_ascii_ply(soup)), soup));
  EXPECT_TRUE(same_soup(ply_soup(print_binary_ply(soup)), soup));
  soup.normals = soup.positions;
  soup.corner_normals = soup.triangles;
  EXPECT_TRUE(same_soup(ply_soup(print_ascii_ply(soup)), soup));
  EXPECT_TRUE(same_soup(ply_soup(print_binary_ply(soup)), soup));
}

}  // namespace
}  // namespace meshalyzer
