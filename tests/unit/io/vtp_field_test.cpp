#include "field_sample.h"
#include "meshalyzer/base/bytes.h"
#include "meshalyzer/io/field_formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <string_view>

namespace meshalyzer {
namespace {

/// The value of an attribute in a tag.
std::string attribute(std::string_view tag, const std::string& name) {
  const std::string front = ' ' + name + "=\"";
  const std::size_t begin = tag.find(front);
  if (begin == std::string_view::npos) {
    return {};
  }
  const std::size_t from = begin + front.size();
  return std::string(tag.substr(from, tag.find('"', from) - from));
}

/// Undoes RFC 4648, section 4.
std::string decode_base64(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int n_bits = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6U | static_cast<unsigned>(kDigits.find(c));
    n_bits += 6;
    if (n_bits >= 8) {
      n_bits -= 8;
      bytes += static_cast<char>(bits >> n_bits & 255U);
    }
  }
  return bytes;
}

/// A file as its format is specified, as far as this is needed.
class VtpFile {
 public:
  explicit VtpFile(std::string text) : text_(std::move(text)) {}

  /// The tag of this name.
  [[nodiscard]] std::string_view tag(const std::string& name) const {
    return tag_in(text_, '<' + name);
  }

  /// Returns the text between a tag and its end.
  [[nodiscard]] std::string_view element(const std::string& name) const {
    const std::string_view all = text_;
    const std::size_t begin = all.find('<' + name);
    return begin == std::string_view::npos ? std::string_view()
                                           : all.substr(begin, all.find("</" + name + '>') - begin);
  }

  /// The bytes of an array in an element, without their number, which must be right.
  [[nodiscard]] std::string bytes(const std::string& in, const std::string& array) const {
    const std::string_view content = array_in(in, array);
    const std::size_t begin = content.find_first_not_of("\n ", content.find('>') + 1);
    const std::size_t end = content.find_first_of("\n <", begin);
    const std::string decoded = decode_base64(content.substr(begin, end - begin));
    if (decoded.size() < 8 ||
        load<std::uint64_t>(decoded.data(), std::endian::little) != decoded.size() - 8) {
      throw std::runtime_error("another number of bytes than it says");
    }
    return decoded.substr(8);
  }

  [[nodiscard]] std::string_view array_tag(const std::string& in, const std::string& array) const {
    return tag_in(array_in(in, array), "<DataArray");
  }

  template <typename T>
  [[nodiscard]] std::vector<T> numbers(const std::string& in, const std::string& array) const {
    const std::string content = bytes(in, array);
    std::vector<T> values(content.size() / sizeof(T));
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = load<T>(content.data() + i * sizeof(T), std::endian::little);
    }
    return values;
  }

 private:
  static std::string_view tag_in(std::string_view text, const std::string& front) {
    const std::size_t begin = text.find(front);
    return text.substr(begin, text.find('>', begin) - begin);
  }

  /// From its tag on.
  [[nodiscard]] std::string_view array_in(const std::string& in, const std::string& array) const {
    const std::string_view content = element(in);
    const std::size_t name = content.find(" Name=\"" + array + '"');
    if (name == std::string_view::npos) {
      throw std::runtime_error("no array " + array);
    }
    return content.substr(content.rfind("<DataArray", name));
  }

  std::string text_;
};

VtpFile vtp_of(const FieldSample& sample = {}) {
  return VtpFile(sample.print(FieldFormat::Vtp));
}

/// To the last bit, so that NaN is NaN.
std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits;
  for (const double value : values) {
    bits.push_back(std::bit_cast<std::uint64_t>(value));
  }
  return bits;
}

TEST(PrintVtpField, HeadSaysHowTheBytesAreToBeRead) {
  const VtpFile file = vtp_of();
  EXPECT_EQ(attribute(file.tag("VTKFile"), "type"), "PolyData");
  EXPECT_EQ(attribute(file.tag("VTKFile"), "byte_order"), "LittleEndian");
  EXPECT_EQ(attribute(file.tag("VTKFile"), "header_type"), "UInt64");
  EXPECT_EQ(attribute(file.tag("VTKFile"), "compressor"), "");
  EXPECT_EQ(attribute(file.tag("Piece"), "NumberOfPoints"), "4");
  EXPECT_EQ(attribute(file.tag("Piece"), "NumberOfPolys"), "2");
}

TEST(PrintVtpField, PointsAreThePositions) {
  const VtpFile file = vtp_of();
  EXPECT_EQ(file.numbers<double>("Points", "Points"),
            (std::vector<double>{0.1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1e300}));
  EXPECT_EQ(attribute(file.array_tag("Points", "Points"), "type"), "Float64");
  EXPECT_EQ(attribute(file.array_tag("Points", "Points"), "NumberOfComponents"), "3");
  EXPECT_EQ(attribute(file.array_tag("Points", "Points"), "format"), "binary");
}

TEST(PrintVtpField, PolygonsAreTheFaces) {
  const VtpFile file = vtp_of();
  EXPECT_EQ(file.numbers<std::int64_t>("Polys", "connectivity"),
            (std::vector<std::int64_t>{0, 1, 2, 3, 1, 0}));
  EXPECT_EQ(file.numbers<std::int64_t>("Polys", "offsets"), (std::vector<std::int64_t>{3, 6}));
  EXPECT_EQ(attribute(file.array_tag("Polys", "connectivity"), "type"), "Int64");
  EXPECT_EQ(attribute(file.array_tag("Polys", "offsets"), "type"), "Int64");
}

TEST(PrintVtpField, ScalarsOfThePointsAreTheField) {
  const FieldSample sample;
  const VtpFile file = vtp_of(sample);
  EXPECT_EQ(attribute(file.tag("PointData"), "Scalars"), "mean");
  EXPECT_EQ(attribute(file.array_tag("PointData", "mean"), "type"), "Float64");
  EXPECT_EQ(bits_of(file.numbers<double>("PointData", "mean")), bits_of(sample.values));
}

TEST(PrintVtpField, ColoursOfThePointsAreBytes) {
  const VtpFile file = vtp_of();
  EXPECT_EQ(file.numbers<std::uint8_t>("PointData", "RGB"),
            (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8, 255, 128, 128, 128}));
  EXPECT_EQ(attribute(file.array_tag("PointData", "RGB"), "type"), "UInt8");
  EXPECT_EQ(attribute(file.array_tag("PointData", "RGB"), "NumberOfComponents"), "3");
}

TEST(PrintVtpField, FieldOfVerticesIsNotOfCells) {
  EXPECT_TRUE(vtp_of().element("CellData").empty());
}

TEST(PrintVtpField, FieldOfFacesIsOfCellsToo) {
  const FieldSample sample = face_field_sample();
  const VtpFile file = vtp_of(sample);
  EXPECT_EQ(attribute(file.tag("CellData"), "Scalars"), "mean");
  EXPECT_EQ(file.numbers<double>("CellData", "mean"), sample.face_values);
  EXPECT_EQ(file.numbers<std::uint8_t>("CellData", "RGB"),
            (std::vector<std::uint8_t>{9, 10, 11, 12, 13, 14}));
  EXPECT_EQ(bits_of(file.numbers<double>("PointData", "mean")), bits_of(sample.values));
}

TEST(PrintVtpField, MeshOfNothingHasEmptyArrays) {
  const VtpFile file(print_vtp_field({}));
  EXPECT_EQ(attribute(file.tag("Piece"), "NumberOfPoints"), "0");
  EXPECT_EQ(file.bytes("Points", "Points"), "");
  EXPECT_EQ(file.bytes("Polys", "offsets"), "");
}

}  // namespace
}  // namespace meshalyzer
