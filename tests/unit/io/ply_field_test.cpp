#include "meshalyzer/io/ply_field.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/bytes.h"
#include "meshalyzer/io/ply.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::string_view kHeaderEnd = "end_header\n";

struct Sample {
  std::vector<Vec3> positions{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1e300}};
  std::vector<Triangle> triangles{{0, 1, 2}, {3, 1, 0}};
  std::vector<double> values{0.1, -2, 1e-300, std::numeric_limits<double>::quiet_NaN()};
  std::vector<Colour> colours{{1, 2, 3}, {4, 5, 6}, {7, 8, 255}, kNoValueColour};

  [[nodiscard]] std::string print() const {
    return print_ply_field(positions, triangles, {values, colours});
  }
};

TEST(PrintPlyField, OurReaderReadsTheMeshBack) {
  const Sample sample;
  const Soup soup = parse_ply(sample.print(), "field.ply");
  EXPECT_EQ(soup.positions, sample.positions);
  EXPECT_EQ(soup.triangles, sample.triangles);
}

TEST(PrintPlyField, HeaderNamesThePropertiesThatViewersKnow) {
  const std::string content = Sample().print();
  EXPECT_EQ(content.substr(0, content.find(kHeaderEnd)),
            "ply\nformat binary_little_endian 1.0\nelement vertex 4\n"
            "property double x\nproperty double y\nproperty double z\nproperty double quality\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "element face 2\nproperty list uchar int vertex_indices\n");
}

TEST(PrintPlyField, EachVertexIsFollowedByItsValueAndColour) {
  const std::string content = Sample().print();
  // The third of the vertices, which are of four doubles and three bytes.
  const char* vertex =
      content.data() + content.find(kHeaderEnd) + kHeaderEnd.size() + 2 * (4 * 8 + 3);
  EXPECT_EQ(load<double>(vertex + 8, std::endian::little), 1.0);
  EXPECT_EQ(load<double>(vertex + 24, std::endian::little), 1e-300);
  EXPECT_EQ(load<std::uint8_t>(vertex + 32, std::endian::little), 7);
  EXPECT_EQ(load<std::uint8_t>(vertex + 33, std::endian::little), 8);
  EXPECT_EQ(load<std::uint8_t>(vertex + 34, std::endian::little), 255);
}

TEST(PrintPlyField, MeshOfNothingIsAFileOfNothing) {
  const Soup soup = parse_ply(print_ply_field({}, {}, {}), "field.ply");
  EXPECT_EQ(soup.n_vertices(), 0U);
  EXPECT_EQ(soup.n_faces(), 0U);
}

TEST(PrintPlyField, FieldOfOtherVerticesIsRefused) {
  Sample sample;
  sample.values.pop_back();
  EXPECT_THROW(static_cast<void>(sample.print()), InvalidArgument);
  sample = Sample();
  sample.colours.pop_back();
  EXPECT_THROW(static_cast<void>(sample.print()), InvalidArgument);
}

TEST(PrintPlyField, CornerThatIsNoVertexIsRefused) {
  Sample sample;
  sample.triangles[1][2] = 4;
  EXPECT_THROW(static_cast<void>(sample.print()), InvalidArgument);
  sample.triangles[1][2] = kNoIndex;
  EXPECT_THROW(static_cast<void>(sample.print()), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
