#include "meshalyzer/io/stl.h"

#include "meshalyzer/base/bytes.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/point_table.h"
#include "meshalyzer/io/print_record.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/stl_layout.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

/// The offset of the corners in a facet, after its normal.
constexpr std::size_t kCornersOffset = 12;
constexpr std::size_t kCornerBytes = 12;

Soup empty_stl_soup() {
  Soup soup;
  soup.format = Format::Stl;
  return soup;
}

void count_merged_points(Soup& soup) {
  soup.n_merged_points = 3 * soup.n_faces() - soup.n_vertices();
}

bool equal_ignoring_case(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

/// Reads the solids of an ASCII file in order; line ends matter only for the names of solids.
class AsciiStlParser {
 public:
  explicit AsciiStlParser(std::string_view text) : in_(text) {}

  Soup parse() {
    in_.require_record("the keyword solid");
    do {
      expect("solid");
      in_.skip_record();
      parse_facets();
    } while (in_.next_record());
    count_merged_points(soup_);
    return std::move(soup_);
  }

 private:
  void parse_facets() {
    for (;;) {
      in_.require_record("endsolid");
      if (equal_ignoring_case(in_.peek(), "endsolid")) {
        static_cast<void>(in_.word());
        in_.skip_record();
        return;
      }
      parse_facet();
    }
  }

  void parse_facet() {
    soup_.face_lines.push_back(static_cast<std::uint32_t>(in_.line()));
    expect("facet");
    expect("normal");
    for (int i = 0; i < 3; ++i) {
      in_.require_record("a normal");
      in_.skip_number();
    }
    expect("outer");
    expect("loop");
    Triangle triangle;
    for (Index& corner : triangle) {
      corner = parse_corner();
    }
    expect("endloop");
    expect("endfacet");
    soup_.triangles.push_back(triangle);
  }

  Index parse_corner() {
    expect("vertex");
    const std::size_t line = in_.line();
    Vec3 point;
    for (double& coordinate : point) {
      in_.require_record("a coordinate");
      coordinate = in_.real();
    }
    const Index vertex = points_.insert(soup_.positions, point);
    soup_.vertex_lines.resize(soup_.n_vertices(), static_cast<std::uint32_t>(line));
    return vertex;
  }

  void expect(std::string_view keyword) {
    in_.require_record(keyword);
    const std::string_view word = in_.word();
    if (!equal_ignoring_case(word, keyword)) {
      in_.fault(in_quotes(word) + " stands where " + std::string(keyword) + " should");
    }
  }

  TextScanner in_;
  Soup soup_ = empty_stl_soup();
  PointTable points_;
};

Soup parse_binary_stl(std::string_view content, const std::string& name) {
  if (content.size() < kStlFacetsOffset) {
    throw IoError(name, {.byte = content.size()},
                  "the file ends within the 84 bytes before the first facet");
  }
  const auto n = load<std::uint32_t>(content.data() + kStlHeaderBytes, std::endian::little);
  if (!is_binary_stl(content)) {
    throw IoError(name, {.byte = kStlHeaderBytes},
                  "a count of " + std::to_string(n) + " facets, which take " +
                      std::to_string(kStlFacetsOffset + kStlFacetBytes * std::uint64_t{n}) +
                      " bytes, but the file has " + std::to_string(content.size()));
  }
  if (n == 0) {
    throw IoError(name, {.byte = kStlHeaderBytes}, "no mesh in it: a count of 0 facets");
  }
  Soup soup = empty_stl_soup();
  PointTable points;
  soup.triangles.resize(n);
  for (std::size_t f = 0; f < n; ++f) {
    std::size_t offset = kStlFacetsOffset + f * kStlFacetBytes + kCornersOffset;
    for (Index& corner : soup.triangles[f]) {
      Vec3 point;
      for (int i = 0; i < 3; ++i) {
        point[i] =
            load<float>(content.data() + offset + static_cast<std::size_t>(i) * sizeof(float),
                        std::endian::little);
      }
      if (!point.allFinite()) {
        throw IoError(name, {.byte = offset}, "a coordinate is not a finite number");
      }
      corner = points.insert(soup.positions, point);
      offset += kCornerBytes;
    }
  }
  count_merged_points(soup);
  return soup;
}

void append_floats(std::string& content, const Vec3& vector) {
  for (const double coordinate : vector) {
    if (std::abs(coordinate) > std::numeric_limits<float>::max()) {
      throw InvalidArgument("coordinate " + shortest(coordinate) +
                            " is beyond the 32-bit floats of binary STL");
    }
    append_little_endian(content, static_cast<float>(coordinate));
  }
}

}  // namespace

Soup parse_stl(std::string_view content, const std::string& name) {
  const bool has_zero_byte = content.find('\0') != std::string_view::npos;
  if (is_binary_stl(content) || has_zero_byte) {
    return parse_binary_stl(content, name);
  }
  return name_fault(name, [&] { return AsciiStlParser(content).parse(); });
}

bool fits_floats(const Soup& soup) {
  const auto is_float = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
  return std::all_of(soup.positions.begin(), soup.positions.end(),
                     [&](const Vec3& p) { return std::all_of(p.begin(), p.end(), is_float); });
}

Vec3 unit_normal(const Soup& soup, const Triangle& triangle) {
  const Vec3 a = soup.positions[triangle[0]];
  const Vec3 u = soup.positions[triangle[1]] - a;
  const Vec3 v = soup.positions[triangle[2]] - a;
  const double u_size = u.lpNorm<Eigen::Infinity>();
  const double v_size = v.lpNorm<Eigen::Infinity>();
  // The face is scaled first, so that neither tiny nor huge faces lose their normal.
  const Vec3 normal = Vec3(u / u_size).cross(Vec3(v / v_size));
  const double length = normal.norm();
  return length > 0.0 && std::isfinite(length) ? Vec3(normal / length) : Vec3(0.0, 0.0, 0.0);
}

std::string print_ascii_stl(const Soup& soup) {
  require_all_vertices(soup);
  std::string text = "solid mesh\n";
  for (const Triangle& triangle : soup.triangles) {
    print_record(text, "facet normal", unit_normal(soup, triangle));
    text += "outer loop\n";
    for (const Index corner : triangle) {
      print_record(text, "vertex", soup.positions[corner]);
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid mesh\n";
}

std::string print_binary_stl(const Soup& soup) {
  require_all_vertices(soup);
  if (soup.n_faces() > std::numeric_limits<std::uint32_t>::max()) {
    throw InvalidArgument("more faces than binary STL can count");
  }
  std::string content = "binary STL, 32-bit floats";
  content.resize(kStlHeaderBytes, ' ');
  content.reserve(kStlFacetsOffset + kStlFacetBytes * soup.n_faces());
  append_little_endian(content, static_cast<std::uint32_t>(soup.n_faces()));
  for (const Triangle& triangle : soup.triangles) {
    append_floats(content, unit_normal(soup, triangle));
    for (const Index corner : triangle) {
      append_floats(content, soup.positions[corner]);
    }
    append_little_endian(content, std::uint16_t{0});
  }
  return content;
}

bool is_binary_stl(std::string_view content) {
  if (content.size() < kStlFacetsOffset) {
    return false;
  }
  const auto n = load<std::uint32_t>(content.data() + kStlHeaderBytes, std::endian::little);
  return content.size() == kStlFacetsOffset + kStlFacetBytes * std::uint64_t{n};
}

}  // namespace meshalyzer
