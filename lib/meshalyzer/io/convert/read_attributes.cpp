#include "meshalyzer/io/convert/read_attributes.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/convert/stl_attributes.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/ply_header.h"
#include "meshalyzer/io/rewrite/inria_records.h"
#include "meshalyzer/io/rewrite/text_lines.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns the number at the end of a record, or 0 if there is none.
std::int32_t reference_of(std::string_view record) {
  const std::int64_t number = parse_integer(inria_numbers(record).back()).value_or(0);
  return std::in_range<std::int32_t>(number) ? static_cast<std::int32_t>(number) : 0;
}

template <typename Number>
void clear_where_all_zero(std::vector<Number>& numbers) {
  const bool is_any_set =
      std::any_of(numbers.begin(), numbers.end(), [](Number number) { return number != 0; });
  if (!is_any_set) numbers.clear();
}

MeshAttributes read_inria_attributes(std::string_view text) {
  MeshAttributes attributes;
  for (const InriaRecords::Section& section : find_inria_records(text).sections) {
    const bool has_vertices = section.keyword == "Vertices";
    const bool has_triangles = section.keyword == "Triangles";
    if (!has_vertices && !has_triangles && section.keyword != "Quadrilaterals") continue;
    for (const std::string_view record : section.records) {
      if (has_vertices) {
        attributes.vertex_references.push_back(reference_of(record));
        continue;
      }
      attributes.faces.append(has_triangles ? 3 : 4);
      attributes.face_references.push_back(reference_of(record));
    }
  }
  clear_where_all_zero(attributes.vertex_references);
  clear_where_all_zero(attributes.face_references);
  return attributes;
}

/// Returns the header of a binary STL file if that is one line of text.
std::vector<std::string> comments_of_stl(std::string_view bytes) {
  const std::string_view header = stl_header(bytes);
  const bool is_text =
      std::all_of(header.begin(), header.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (header.empty() || !is_text) return {};
  return {' ' + std::string(header)};
}

MeshAttributes read_by_format(const Soup& soup, std::string_view bytes) {
  MeshAttributes attributes;
  attributes.faces = single_triangles(soup.n_faces());
  switch (soup.format) {
    case Format::Obj:
      return read_obj_attributes(bytes);
    case Format::Off:
      return is_binary(bytes, Format::Off) ? attributes : read_off_attributes(soup, bytes);
    case Format::Ply:
      return read_ply_attributes(soup, bytes);
    case Format::Inria:
      return read_inria_attributes(bytes);
    case Format::Stl:
      if (is_binary(bytes, Format::Stl)) {
        attributes.attribute_words = read_attribute_words(bytes, soup.n_faces());
        clear_where_all_zero(attributes.attribute_words);
        attributes.comments = comments_of_stl(bytes);
      } else {
        attributes.solids = named_solids(bytes);
      }
      return attributes;
    case Format::Mesh:
      break;
  }
  return attributes;
}

/// Returns the comments and notes in the header of a PLY file.
std::vector<std::string> ply_comments(std::string_view content) {
  std::vector<std::string> comments;
  TextScanner in(content.substr(0, parse_ply_header(content).n_bytes));
  while (in.next_record()) {
    const std::string_view keyword = in.word();
    const std::size_t begin = static_cast<std::size_t>(keyword.data() - content.data());
    const std::size_t text = begin + keyword.size();
    in.skip_record();
    if (keyword == "comment" || keyword == "obj_info") {
      const std::string_view line = content.substr(text, content.find('\n', text) - text);
      comments.emplace_back(line.substr(0, line.find_last_not_of(" \t\r") + 1));
    }
  }
  return comments;
}

/// Returns the comments before an offset of a text.
std::vector<std::string> comments_before(std::string_view text, std::size_t end) {
  std::vector<std::string> comments;
  for (std::size_t at = 0; at < end;) {
    const std::size_t line_end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, line_end - at);
    const std::size_t mark = line.find('#');
    // In a name, # does not begin a comment.
    if (mark == 0 || (mark != std::string_view::npos &&
                      std::string_view(" \t").find(line[mark - 1]) != std::string_view::npos)) {
      comments.emplace_back(line.substr(mark + 1, line.find_last_not_of(" \t\r") - mark));
    }
    at = line_end + 1;
  }
  return comments;
}

/// Returns the offset of the line of the first record of a text.
std::size_t first_record(const Soup& soup, std::string_view text) {
  std::size_t line = soup.vertex_lines.empty() ? 1 : soup.vertex_lines.front();
  if (!soup.face_lines.empty()) {
    line = std::min<std::size_t>(line, soup.face_lines.front());
  }
  return line_offset(text, line);
}

/// Drops colours that are not numbers, which only text formats could hold.
void drop_unreal(std::vector<std::optional<Rgba>>& colours) {
  for (std::optional<Rgba>& colour : colours) {
    if (colour && !std::all_of(colour->begin(), colour->end(),
                               [](double part) { return std::isfinite(part); })) {
      colour.reset();
    }
  }
}

}  // namespace

MeshAttributes read_attributes(const Soup& soup, std::string_view bytes) {
  MeshAttributes attributes = read_by_format(soup, bytes);
  drop_unreal(attributes.vertex_colours);
  drop_unreal(attributes.face_colours);
  if (soup.format == Format::Ply) {
    attributes.comments = ply_comments(bytes);
  } else if (!is_binary(bytes, soup.format)) {
    attributes.comments = comments_before(bytes, first_record(soup, bytes));
  }
  return attributes;
}

}  // namespace meshalyzer
