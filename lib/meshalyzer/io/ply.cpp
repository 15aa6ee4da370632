#include "meshalyzer/io/ply.h"

#include "meshalyzer/base/bytes.h"
#include "meshalyzer/io/ply_header.h"
#include "meshalyzer/io/ply_names.h"
#include "meshalyzer/io/ply_source.h"
#include "meshalyzer/io/print_record.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The place of a property of vertices that is not stored.
constexpr std::size_t kSkipped = kPlyVertexNumbers.size();

/// Reads the records after the header in order, from either source of numbers.
template <typename Source>
class PlyBody {
 public:
  PlyBody(const PlyHeader& header, Source source) : header_(header), source_(std::move(source)) {}

  Soup parse() {
    soup_.format = Format::Ply;
    soup_.vertex_ids.first = 0;
    soup_.face_ids.first = 0;
    for (const PlyElement& element : header_.elements) {
      source_.check_count(element);
      if (element.name == "vertex") {
        parse_vertices(element);
      } else if (element.name == "face") {
        parse_faces(element);
      } else if (element.name == "tristrips") {
        parse_strips(element);
      } else {
        skip_records(element);
      }
    }
    source_.finish();
    resolve_indices(soup_);
    use_vertex_normals(soup_);
    return std::move(soup_);
  }

 private:
  void parse_vertices(const PlyElement& element) {
    const std::vector<std::size_t> places = places_of(element);
    const auto has = [&](std::size_t i) {
      return std::count(places.begin(), places.end(), i) == 1;
    };
    const bool has_normals = has(3) && has(4) && has(5);
    for (std::size_t i = 0; i < element.count; ++i) {
      source_.begin_record(element);
      append_line(soup_.vertex_lines);
      const std::array<double, kSkipped> numbers = read_vertex(element, places);
      soup_.positions.emplace_back(numbers[0], numbers[1], numbers[2]);
      if (has_normals) {
        soup_.normals.emplace_back(numbers[3], numbers[4], numbers[5]);
      }
      source_.end_record();
    }
  }

  /// Returns for each property its index in kPlyVertexNumbers, or kSkipped.
  static std::vector<std::size_t> places_of(const PlyElement& element) {
    std::vector<std::size_t> places;
    for (const PlyProperty& property : element.properties) {
      const auto* const found =
          std::find(kPlyVertexNumbers.begin(), kPlyVertexNumbers.end(), property.name);
      places.push_back(property.list_size_type
                           ? kSkipped
                           : static_cast<std::size_t>(found - kPlyVertexNumbers.begin()));
    }
    return places;
  }

  std::array<double, kSkipped> read_vertex(const PlyElement& element,
                                           const std::vector<std::size_t>& places) {
    std::array<double, kSkipped> numbers{};
    for (std::size_t p = 0; p < places.size(); ++p) {
      if (places[p] == kSkipped) {
        skip_property(element.properties[p]);
      } else {
        numbers[places[p]] = source_.real(element.properties[p].type);
      }
    }
    return numbers;
  }

  void parse_faces(const PlyElement& element) {
    for (std::size_t i = 0; i < element.count; ++i) {
      source_.begin_record(element);
      const std::size_t line = source_.line();
      for (const PlyProperty& property : element.properties) {
        if (is_corner_list(property)) {
          read_corners(property);
        } else {
          skip_property(property);
        }
      }
      append_polygon(soup_, corners_, line);
      source_.end_record();
    }
  }

  void parse_strips(const PlyElement& element) {
    for (std::size_t i = 0; i < element.count; ++i) {
      source_.begin_record(element);
      for (const PlyProperty& property : element.properties) {
        if (is_corner_list(property)) {
          read_strips(property);
        } else {
          skip_property(property);
        }
      }
      source_.end_record();
    }
  }

  /// Reads a list of strips, separated by -1: every three consecutive corners are a face, every
  /// other one reversed.
  void read_strips(const PlyProperty& property) {
    corners_.clear();
    for (std::size_t left = source_.list_size(property); left > 0; --left) {
      const Index corner = source_.index_of_strip(property.type);
      if (corner == kNoIndex) {
        corners_.clear();
        continue;
      }
      corners_.push_back(corner);
      if (const std::size_t n = corners_.size(); n >= 3) {
        const std::size_t first = n % 2 == 0 ? n - 2 : n - 3;
        const std::size_t second = n % 2 == 0 ? n - 3 : n - 2;
        soup_.triangles.push_back({corners_[first], corners_[second], corner});
        append_line(soup_.face_lines);
      }
    }
  }

  void read_corners(const PlyProperty& property) {
    const std::size_t n = source_.list_size(property);
    if (n == 0) {
      source_.fault("a face without corners");
    }
    corners_.clear();
    for (std::size_t i = 0; i < n; ++i) {
      corners_.push_back(source_.index(property.type));
    }
  }

  void skip_records(const PlyElement& element) {
    // Records without properties take neither bytes nor lines.
    const std::size_t n = element.properties.empty() ? 0 : element.count;
    for (std::size_t i = 0; i < n; ++i) {
      source_.begin_record(element);
      for (const PlyProperty& property : element.properties) {
        skip_property(property);
      }
      source_.end_record();
    }
  }

  void skip_property(const PlyProperty& property) {
    const std::size_t n = property.list_size_type ? source_.list_size(property) : 1;
    for (std::size_t i = 0; i < n; ++i) {
      source_.skip(property.type);
    }
  }

  void append_line(std::vector<std::uint32_t>& lines) const {
    if (source_.line() != 0) {
      lines.push_back(static_cast<std::uint32_t>(source_.line()));
    }
  }

  const PlyHeader& header_;
  Source source_;
  Soup soup_;
  /// The corners of the face being read.
  std::vector<Index> corners_;
};

std::string print_header(const Soup& soup, std::string_view encoding) {
  std::string text = "ply\nformat " + std::string(encoding) + " 1.0\n";
  text += "element vertex " + std::to_string(soup.n_vertices()) + '\n';
  const std::size_t n_numbers = has_vertex_normals(soup) ? 6 : 3;
  for (std::size_t i = 0; i < n_numbers; ++i) {
    text += "property double " + std::string(kPlyVertexNumbers[i]) + '\n';
  }
  text += "element face " + std::to_string(soup.n_faces()) +
          "\nproperty list uchar int vertex_indices\n";
  return text + "end_header\n";
}

}  // namespace

Soup parse_ply(std::string_view content, const std::string& name) {
  return name_fault(name, [&] {
    const PlyHeader header = parse_ply_header(content);
    if (header.encoding == PlyEncoding::Ascii) {
      return PlyBody(header, AsciiPlySource(content, header)).parse();
    }
    return PlyBody(header, BinaryPlySource(content, header, name)).parse();
  });
}

std::string print_ascii_ply(const Soup& soup) {
  require_all_vertices(soup);
  std::string text = print_header(soup, "ascii");
  print_vertices_and_triangles(text, soup);
  return text;
}

std::string print_binary_ply(const Soup& soup) {
  require_all_vertices(soup);
  std::string content = print_header(soup, "binary_little_endian");
  for_each_vertex(soup, [&](const std::vector<double>& numbers) {
    for (const double number : numbers) {
      append_little_endian(content, number);
    }
  });
  for (const Triangle& t : soup.triangles) {
    append_little_endian(content, std::uint8_t{3});
    for (const Index corner : t) {
      append_little_endian(content, static_cast<std::int32_t>(corner));
    }
  }
  return content;
}

}  // namespace meshalyzer
