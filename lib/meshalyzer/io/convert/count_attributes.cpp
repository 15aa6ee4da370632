#include "meshalyzer/io/convert/count_attributes.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/binary_off.h"
#include "meshalyzer/io/convert/stl_attributes.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/ply_header.h"
#include "meshalyzer/io/ply_names.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/inria_records.h"
#include "meshalyzer/io/rewrite/off_records.h"
#include "meshalyzer/io/rewrite/text_lines.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using Counts = std::vector<AttributeCount>;

template <typename List, typename Predicate>
std::size_t count_if(const List& list, Predicate predicate) {
  return static_cast<std::size_t>(std::count_if(list.begin(), list.end(), predicate));
}

/// Tells whether the rest of a statement is a name, in which `#` does not begin a comment.
bool begins_name(std::string_view keyword, Format format) {
  constexpr std::array<std::string_view, 5> kOfObj = {"g", "o", "s", "usemtl", "mtllib"};
  if (format == Format::Obj) return is_one_of(keyword, kOfObj);
  // Of the keywords of STL, in any case, only solid and endsolid end so.
  return format == Format::Stl && (keyword.ends_with("lid") || keyword.ends_with("LID"));
}

/// Counts the comments of a text: what its reader takes for comments.
std::size_t count_comments(std::string_view text, Format format) {
  TextScanner in(text, format == Format::Obj ? Continuation::Backslash : Continuation::None);
  while (in.next_record()) {
    if (begins_name(in.word(), format)) static_cast<void>(in.rest_of_record());
    in.skip_record();
  }
  return in.n_comments();
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
  const auto n_read = std::count_if(
      element.properties.begin(), element.properties.end(), [&](const PlyProperty& p) {
        return is_one_of(p.name, kPlyVertexNumbers) && !p.list_size_type;
      });
  const bool has_normal = n_read == std::ssize(kPlyVertexNumbers);
  return is_one_of(property.name, kPlyVertexNumbers) && (has_normal || property.name.size() == 1);
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

Counts count_binary_off(std::string_view content) {
  const BinaryOff off = parse_binary_off(content, "");
  return {{AttributeKind::TextureCoordinates, off.n_texture_points},
          {AttributeKind::VertexColours, off.n_vertex_colours},
          {AttributeKind::FaceColours, off.n_face_colours}};
}

/// Counts the numbers after the positions and normals of vertices and after the corners of faces.
Counts count_off_text(const Soup& soup, std::string_view text) {
  const OffRecords records = find_off_records(text, soup.n_vertices());
  const bool has_texture = records.layout.texture;
  const std::size_t n_own = (has_vertex_normals(soup) ? 6U : 3U) + (has_texture ? 2U : 0U);
  const auto has_vertex_colour = [&](std::size_t begin) {
    return words_at(text, begin, Continuation::None).size() > n_own;
  };
  const auto has_face_colour = [&](std::size_t begin) {
    const std::vector<std::string_view> words = words_at(text, begin, Continuation::None);
    return words.size() > 1 + static_cast<std::size_t>(parse_integer(words[0]).value_or(0));
  };
  return {{AttributeKind::TextureCoordinates, has_texture ? soup.n_vertices() : 0},
          {AttributeKind::VertexColours, count_if(records.vertices, has_vertex_colour)},
          {AttributeKind::FaceColours, count_if(records.faces, has_face_colour)}};
}

Counts count_stl(const Soup& soup, std::string_view content) {
  if (!is_binary(content, Format::Stl)) {
    return {{AttributeKind::Groups, count_if(named_solids(content), [](const Group& solid) {
               return !solid.name.empty();
             })}};
  }
  const auto is_set = [](std::uint16_t word) { return word != 0; };
  return {{AttributeKind::AttributeWords,
           count_if(read_attribute_words(content, soup.n_faces()), is_set)},
          {AttributeKind::Headers, stl_header(content).empty() ? 0U : 1U}};
}

/// Counts the references of records in INRIA's format, and the statements and records that do not
/// concern triangles.
Counts count_inria(std::string_view text) {
  const InriaRecords records = find_inria_records(text);
  const auto has_reference = [](std::string_view record) {
    return parse_integer(inria_numbers(record).back()) != 0;
  };
  Counts counts{{AttributeKind::OtherRecords, records.n_statements}};
  for (const InriaRecords::Section& section : records.sections) {
    counts.push_back(
        section.kind == nullptr
            ? AttributeCount{AttributeKind::References, count_if(section.records, has_reference)}
            : AttributeCount{AttributeKind::OtherRecords, section.records.size()});
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
      return is_binary(bytes, Format::Off) ? count_binary_off(bytes) : count_off_text(soup, bytes);
    case Format::Stl:
      return count_stl(soup, bytes);
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
    counts.push_back({AttributeKind::Comments, count_comments(bytes, soup.format)});
  }
  return summed(std::move(counts));
}

}  // namespace meshalyzer
