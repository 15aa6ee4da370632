#include "meshalyzer/io/binary_off.h"

#include "meshalyzer/base/bytes.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/io/off_keyword.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The size of every number in bytes.
constexpr std::size_t kNumberBytes = 4;
constexpr std::size_t kColourNumbers = 4;
constexpr std::size_t kTextureNumbers = 2;

/// Reads the numbers of one file in order.
class BinaryOffParser {
 public:
  BinaryOffParser(std::string_view content, const std::string& name)
      : content_(content), name_(name) {}

  BinaryOff parse() {
    Soup& soup = off_.soup;
    soup.format = Format::Off;
    soup.vertex_ids.first = 0;
    soup.face_ids.first = 0;
    parse_keyword();
    const std::size_t n_vertices = count(3 * kNumberBytes, "vertices");
    // The smallest face has its number of corners, one corner, and its number of colours.
    const std::size_t n_faces = count(3 * kNumberBytes, "faces");
    static_cast<void>(integer());  // the number of edges, which is rarely right
    for (std::size_t i = 0; i < n_vertices; ++i) {
      parse_vertex();
    }
    for (std::size_t i = 0; i < n_faces; ++i) {
      parse_face();
    }
    finish();
    off_.n_vertex_colours = layout_.colour ? n_vertices : 0;
    off_.n_texture_points = layout_.texture ? n_vertices : 0;
    resolve_indices(soup);
    use_vertex_normals(soup);
    return std::move(off_);
  }

 private:
  void parse_keyword() {
    const std::size_t end = std::min(content_.find('\n'), content_.size());
    TextScanner line(content_.substr(0, end));
    static_cast<void>(line.next_record());
    layout_ = parse_off_keyword(line.word(), line);
    static_cast<void>(line.word());  // BINARY
    line.end_record();
    at_ = std::min(end + 1, content_.size());
  }

  void parse_vertex() {
    off_.soup.positions.push_back(point());
    if (layout_.normal) {
      off_.soup.normals.push_back(point());
    }
    skip((layout_.colour ? kColourNumbers : 0) + (layout_.texture ? kTextureNumbers : 0));
  }

  void parse_face() {
    const std::size_t n_corners = count(kNumberBytes, "corners");
    if (n_corners == 0) {
      fault(at_ - kNumberBytes, "a face without corners");
    }
    corners_.clear();
    for (std::size_t i = 0; i < n_corners; ++i) {
      corners_.push_back(index());
    }
    append_polygon(off_.soup, corners_, 0);
    const std::size_t n_colours = count(kNumberBytes, "colour components");
    off_.n_face_colours += n_colours != 0 ? 1 : 0;
    skip(n_colours);
  }

  void finish() const {
    const std::string_view rest = content_.substr(at_);
    if (rest.find_first_not_of(" \t\r\n") != std::string_view::npos) {
      fault(at_, std::to_string(rest.size()) + " bytes more than the header counts");
    }
  }

  [[nodiscard]] Vec3 point() {
    const double x = real();
    const double y = real();
    const double z = real();
    return {x, y, z};
  }

  [[nodiscard]] double real() {
    const std::size_t offset = at_;
    const auto value = number<float>();
    if (!std::isfinite(value)) {
      fault(offset, "a number is not finite");
    }
    return static_cast<double>(value);
  }

  [[nodiscard]] std::int32_t integer() { return number<std::int32_t>(); }

  [[nodiscard]] Index index() {
    const std::size_t offset = at_;
    const std::int32_t value = integer();
    if (value < 0) {
      fault(offset, "index " + std::to_string(value) + ": indices count from 0");
    }
    return static_cast<Index>(value);
  }

  /// Returns the number of records that follow; rejects a count that the rest of the file cannot
  /// hold.
  /// @param bytes_each  The smallest size of a record.
  [[nodiscard]] std::size_t count(std::size_t bytes_each, const std::string& what) {
    const std::size_t offset = at_;
    const std::int32_t value = integer();
    const std::size_t left = content_.size() - at_;
    if (value < 0 || static_cast<std::size_t>(value) > left / bytes_each) {
      fault(offset, "a count of " + std::to_string(value) + " " + what + ", but only " +
                        std::to_string(left) + " bytes follow");
    }
    return static_cast<std::size_t>(value);
  }

  template <typename T>
  [[nodiscard]] T number() {
    static_assert(sizeof(T) == kNumberBytes);
    const std::size_t offset = at_;
    skip(1);
    return load<T>(content_.data() + offset, std::endian::big);
  }

  void skip(std::size_t n_numbers) {
    if ((content_.size() - at_) / kNumberBytes < n_numbers) {
      fault(at_, "the file ends within a record");
    }
    at_ += n_numbers * kNumberBytes;
  }

  [[noreturn]] void fault(std::size_t offset, const std::string& what) const {
    throw IoError(name_, {.byte = offset}, what);
  }

  std::string_view content_;
  const std::string& name_;
  BinaryOff off_;
  OffLayout layout_;
  std::size_t at_ = 0;
  /// The corners of the face being read.
  std::vector<Index> corners_;
};

}  // namespace

BinaryOff parse_binary_off(std::string_view content, const std::string& name) {
  return BinaryOffParser(content, name).parse();
}

}  // namespace meshalyzer
