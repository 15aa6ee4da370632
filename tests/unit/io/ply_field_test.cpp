#include "field_sample.h"
#include "meshalyzer/base/bytes.h"
#include "meshalyzer/io/field_formats.h"
#include "meshalyzer/io/ply.h"

#include <gtest/gtest.h>

#include <limits>

namespace meshalyzer {
namespace {

constexpr std::string_view kHeaderEnd = "end_header\n";
/// Four doubles and three bytes.
constexpr std::size_t kVertexBytes = 4 * 8 + 3;

std::string ply_of(const FieldSample& sample = {}) {
  return sample.print(FieldFormat::Ply);
}

TEST(PrintPlyField, OurReaderReadsTheMeshBack) {
  for (const FieldSample& sample : {FieldSample(), face_field_sample()}) {
    const Soup soup = parse_ply(ply_of(sample), "field.ply");
    EXPECT_EQ(soup.positions, sample.positions);
    EXPECT_EQ(soup.triangles, sample.triangles);
  }
}

TEST(PrintPlyField, HeaderNamesThePropertiesThatViewersKnow) {
  const std::string content = ply_of();
  EXPECT_EQ(content.substr(0, content.find(kHeaderEnd)),
            "ply\nformat binary_little_endian 1.0\nelement vertex 4\n"
            "property double x\nproperty double y\nproperty double z\nproperty double quality\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "element face 2\nproperty list uchar int vertex_indices\n");
}

TEST(PrintPlyField, CommentsFollowTheFormat) {
  FieldSample sample;
  sample.comments = {"one", "two words"};
  EXPECT_EQ(ply_of(sample).rfind("ply\nformat binary_little_endian 1.0\n"
                                 "comment one\ncomment two words\nelement vertex 4\n",
                                 0),
            0U);
}

TEST(PrintPlyField, EachVertexIsFollowedByItsValueAndColour) {
  const std::string content = ply_of();
  // The third of the vertices.
  const char* vertex =
      content.data() + content.find(kHeaderEnd) + kHeaderEnd.size() + 2 * kVertexBytes;
  EXPECT_EQ(load<double>(vertex + 8, std::endian::little), 1.0);
  EXPECT_EQ(load<double>(vertex + 24, std::endian::little), 1e-300);
  EXPECT_EQ(load<std::uint8_t>(vertex + 32, std::endian::little), 7);
  EXPECT_EQ(load<std::uint8_t>(vertex + 33, std::endian::little), 8);
  EXPECT_EQ(load<std::uint8_t>(vertex + 34, std::endian::little), 255);
}

TEST(PrintPlyField, FieldOfFacesHasTheirValuesToo) {
  const std::string content = ply_of(face_field_sample());
  // The second of the faces, which are of a count, three indices, a value and a colour.
  const char* face = content.data() + content.find(kHeaderEnd) + kHeaderEnd.size() +
                     4 * kVertexBytes + (1 + 3 * 4 + 8 + 3);
  EXPECT_EQ(load<std::uint8_t>(face, std::endian::little), 3);
  EXPECT_EQ(load<std::int32_t>(face + 1, std::endian::little), 3);
  EXPECT_EQ(load<double>(face + 13, std::endian::little), std::numeric_limits<double>::infinity());
  EXPECT_EQ(load<std::uint8_t>(face + 23, std::endian::little), 14);
  EXPECT_EQ(face + 24, content.data() + content.size());
}

TEST(PrintPlyField, MeshOfNothingIsAFileOfNothing) {
  const Soup soup = parse_ply(print_ply_field({}), "field.ply");
  EXPECT_EQ(soup.n_vertices(), 0U);
  EXPECT_EQ(soup.n_faces(), 0U);
}

}  // namespace
}  // namespace meshalyzer
