#include "meshalyzer/io/convert/count_attributes.h"

#include "meshalyzer/base/bytes.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/binary_off.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/ply_header.h"
#include "meshalyzer/io/ply_names.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/stl_layout.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

using Counts = std::vector<AttributeCount>;

/// Counts the lines with a comment; inside a word, `#` does not begin one.
std::size_t count_comments(std::string_view text) {
  constexpr std::string_view kBefore = " \t\r\n";
  std::size_t n = 0;
  for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at)) {
    const bool begins = at == 0 || kBefore.find(text[at - 1]) != std::string_view::npos;
    n += begins ? 1 : 0;
    at = begins ? std::min(text.find('\n', at), text.size()) : at + 1;
  }
  return n;
}

std::size_t count_words(TextScanner& in) {
  std::size_t n = 0;
  for (; !in.at_record_end(); ++n) {
    static_cast<void>(in.word());
  }
  return n;
}

/// Counts the statements of an OBJ file.
class ObjCounter {
 public:
  explicit ObjCounter(std::string_view text) : in_(text, Continuation::Backslash) {}

  Counts count() {
    while (in_.next_record()) {
      count_statement(in_.word());
      in_.skip_record();
    }
    return {{AttributeKind::TextureCoordinates, n_texture_points_},
            {AttributeKind::VertexColours, n_colours_},
            {AttributeKind::Materials, materials_.size()},
            {AttributeKind::Groups, groups_.size()},
            {AttributeKind::SmoothingGroups, smoothing_groups_.size()},
            {AttributeKind::VertexProperties, has_weights_ ? 1U : 0U},
            {AttributeKind::LinesAndPoints, n_lines_},
            {AttributeKind::OtherStatements, n_others_}};
  }

 private:
  void count_statement(std::string_view keyword) {
    if (keyword == "v") {
      count_vertex();
    } else if (keyword == "vt") {
      ++n_texture_points_;
    } else if (keyword == "usemtl") {
      materials_.insert(in_.rest_of_record());
    } else if (keyword == "g" || keyword == "o") {
      groups_.insert(in_.rest_of_record());
    } else if (keyword == "s") {
      smoothing_groups_.insert(in_.rest_of_record());
    } else if (keyword == "l" || keyword == "p") {
      ++n_lines_;
    } else if (keyword != "f" && keyword != "fo" && keyword != "vn") {
      ++n_others_;
    }
  }

  /// Counts the colour of a vertex, and notes a weight, which is 1 where there is none.
  void count_vertex() {
    std::size_t n_words = 0;
    std::string_view weight;
    for (; !in_.at_record_end(); ++n_words) {
      const std::string_view word = in_.word();
      if (n_words == 3) weight = word;
    }
    n_colours_ += n_words >= 6 ? 1 : 0;
    const bool has_weight = n_words == 4 || n_words == 7;
    has_weights_ = has_weights_ || (has_weight && parse_real(weight) != 1.0);
  }

  TextScanner in_;
  bool has_weights_ = false;
  std::size_t n_texture_points_ = 0;
  std::size_t n_colours_ = 0;
  std::size_t n_lines_ = 0;
  std::size_t n_others_ = 0;
  std::set<std::string> materials_;
  std::set<std::string> groups_;
  std::set<std::string> smoothing_groups_;
};

/// Tells whether the reader takes a number of a vertex: a position, or a normal that is whole.
bool is_read_of_vertex(const PlyElement& element, const PlyProperty& property) {
  constexpr std::array<std::string_view, 3> kPosition = {"x", "y", "z"};
  constexpr std::array<std::string_view, 3> kNormal = {"nx", "ny", "nz"};
  const auto n_of_normal = std::count_if(
      element.properties.begin(), element.properties.end(),
      [&](const PlyProperty& p) { return is_one_of(p.name, kNormal) && !p.list_size_type; });
  return is_one_of(property.name, kPosition) ||
         (is_one_of(property.name, kNormal) && n_of_normal == 3);
}

Counts count_ply_element(const PlyElement& element) {
  const bool is_vertex = element.name == "vertex";
  std::size_t n_others = 0;
  bool has_colour = false;
  bool has_texture = false;
  for (const PlyProperty& property : element.properties) {
    const bool is_read =
        is_vertex ? is_read_of_vertex(element, property) : is_corner_list(property);
    if (is_ply_colour(property.name)) {
      has_colour = true;
    } else if (is_ply_texture(property.name)) {
      has_texture = true;
    } else {
      n_others += is_read ? 0 : 1;
    }
  }
  return {{is_vertex ? AttributeKind::VertexColours : AttributeKind::FaceColours,
           has_colour ? element.count : 0},
          {AttributeKind::TextureCoordinates, has_texture ? element.count : 0},
          {is_vertex ? AttributeKind::VertexProperties : AttributeKind::FaceProperties, n_others}};
}

Counts count_ply(std::string_view content) {
  const PlyHeader header = parse_ply_header(content);
  Counts counts;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex" || has_corners(element)) {
      const Counts of_element = count_ply_element(element);
      counts.insert(counts.end(), of_element.begin(), of_element.end());
    } else {
      counts.push_back({AttributeKind::OtherRecords, element.count});
    }
  }
  TextScanner in(content.substr(0, header.n_bytes));
  while (in.next_record()) {
    const std::string_view keyword = in.word();
    counts.push_back(
        {AttributeKind::Comments, keyword == "comment" || keyword == "obj_info" ? 1U : 0U});
    in.skip_record();
  }
  return counts;
}

std::string_view from_line(std::string_view text, std::size_t line) {
  std::size_t begin = 0;
  for (std::size_t l = 1; l < line; ++l) {
    begin = text.find('\n', begin) + 1;
  }
  return text.substr(begin);
}

Counts count_binary_off(std::string_view content) {
  const BinaryOff off = parse_binary_off(content, "");
  return {{AttributeKind::TextureCoordinates, off.n_texture_points},
          {AttributeKind::VertexColours, off.n_vertex_colours},
          {AttributeKind::FaceColours, off.n_face_colours}};
}

/// Counts the numbers after the positions and normals of vertices and after the corners of faces.
Counts count_off_text(const Soup& soup, std::string_view text) {
  TextScanner head(text);
  static_cast<void>(head.next_record());
  const bool has_texture = head.peek().substr(0, 2) == "ST";
  const std::size_t n_own = (has_vertex_normals(soup) ? 6U : 3U) + (has_texture ? 2U : 0U);
  std::size_t n_vertex_colours = 0;
  std::size_t n_face_colours = 0;
  std::size_t n_left = soup.n_vertices();
  TextScanner in(from_line(text, soup.vertex_lines.front()));
  for (; in.next_record(); in.skip_record()) {
    if (n_left > 0) {
      --n_left;
      n_vertex_colours += count_words(in) > n_own ? 1 : 0;
    } else {
      const auto n_corners = static_cast<std::size_t>(in.integer());
      n_face_colours += count_words(in) > n_corners ? 1 : 0;
    }
  }
  return {{AttributeKind::TextureCoordinates, has_texture ? soup.n_vertices() : 0},
          {AttributeKind::VertexColours, n_vertex_colours},
          {AttributeKind::FaceColours, n_face_colours}};
}

Counts count_off(const Soup& soup, std::string_view content) {
  if (is_binary(content, Format::Off)) {
    return count_binary_off(content);
  }
  return soup.vertex_lines.empty() ? Counts{} : count_off_text(soup, content);
}

Counts count_binary_stl(std::string_view content) {
  const bool has_header =
      content.substr(0, kStlHeaderBytes).find_first_not_of(std::string_view(" \0", 2)) !=
      std::string_view::npos;
  std::size_t n_words = 0;
  for (std::size_t at = kStlFacetsOffset + kStlAttributeOffset; at < content.size();
       at += kStlFacetBytes) {
    n_words += load<std::uint16_t>(content.data() + at, std::endian::little) != 0 ? 1 : 0;
  }
  return {{AttributeKind::AttributeWords, n_words}, {AttributeKind::Headers, has_header ? 1U : 0U}};
}

/// Counts the solids that have a name.
Counts count_ascii_stl(std::string_view text) {
  TextScanner in(text);
  std::size_t n_names = 0;
  while (in.next_record()) {
    const std::string_view word = in.word();
    if (word.size() == 5 && (word[0] == 's' || word[0] == 'S')) {
      n_names += in.at_record_end() ? 0 : 1;
      in.skip_record();
    }
  }
  return {{AttributeKind::Groups, n_names}};
}

/// Tells whether a statement of INRIA's format has numbers or a name behind it, but no count.
bool is_single_statement(std::string_view keyword) {
  constexpr std::array<std::string_view, 4> kStatements = {"AngleOfCornerBound", "BoundingBox",
                                                           "Geometry", "Identifier"};
  return is_one_of(keyword, kStatements);
}

/// Counts the references of records in INRIA's format, and the statements and records that do not
/// concern triangles.
Counts count_inria(std::string_view text) {
  constexpr std::array<std::string_view, 5> kRead = {"MeshVersionFormatted", "Dimension",
                                                     "Vertices", "Triangles", "Quadrilaterals"};
  TextScanner in(text);
  Counts counts;
  std::string section;
  std::size_t n_numbers = 0;
  while (in.next_record()) {
    const std::string_view word = in.word();
    const bool is_keyword =
        (word[0] >= 'A' && word[0] <= 'Z') || (word[0] >= 'a' && word[0] <= 'z');
    if (word == "End") break;
    if (is_keyword) {
      section = std::string(word);
      n_numbers = 0;
      if (word == "Geometry" || word == "Identifier") in.skip_record();
      counts.push_back({AttributeKind::OtherRecords, is_single_statement(word) ? 1U : 0U});
    } else if (++n_numbers == 1 && !is_one_of(section, kRead) && !is_single_statement(section)) {
      // The first number is the count of a section.
      counts.push_back(
          {AttributeKind::OtherRecords,
           static_cast<std::size_t>(std::max<std::int64_t>(parse_integer(word).value_or(0), 0))});
    } else if ((section == "Vertices" || section == "Triangles") && n_numbers % 4 == 1 &&
               n_numbers > 1) {
      counts.push_back({AttributeKind::References, word == "0" ? 0U : 1U});
    } else if (section == "Quadrilaterals" && n_numbers % 5 == 1 && n_numbers > 1) {
      counts.push_back({AttributeKind::References, word == "0" ? 0U : 1U});
    }
  }
  return counts;
}

Counts count_by_format(const Soup& soup, std::string_view bytes) {
  switch (soup.format) {
    case Format::Obj:
      return ObjCounter(bytes).count();
    case Format::Ply:
      return count_ply(bytes);
    case Format::Off:
      return count_off(soup, bytes);
    case Format::Stl:
      return is_binary(bytes, Format::Stl) ? count_binary_stl(bytes) : count_ascii_stl(bytes);
    case Format::Inria:
      return count_inria(bytes);
    case Format::Mesh:
      break;
  }
  return {};
}

}  // namespace

std::vector<AttributeCount> count_attributes(const Soup& soup, std::string_view bytes) {
  Counts counts = count_by_format(soup, bytes);
  counts.push_back({AttributeKind::Polygons, soup.n_polygons});
  counts.push_back({AttributeKind::Normals, soup.normals.size()});
  if (soup.format != Format::Ply && !is_binary(bytes, soup.format)) {
    counts.push_back({AttributeKind::Comments, count_comments(bytes)});
  }
  return summed(std::move(counts));
}

}  // namespace meshalyzer
