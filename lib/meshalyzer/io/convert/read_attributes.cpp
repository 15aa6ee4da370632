#include "meshalyzer/io/convert/read_attributes.h"

#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/ply_header.h"
#include "meshalyzer/io/rewrite/inria_records.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace meshalyzer {
namespace {

FaceRecords inria_faces(std::string_view text) {
  FaceRecords faces;
  faces.first_triangle.push_back(0);
  for (const InriaRecords::Section& section : find_inria_records(text).sections) {
    if (section.keyword == "Triangles" || section.keyword == "Quadrilaterals") {
      for (std::size_t i = 0; i < section.records.size(); ++i) {
        faces.first_triangle.push_back(faces.first_triangle.back() +
                                       (section.keyword == "Triangles" ? 1 : 2));
      }
    }
  }
  return faces;
}

/// The solids of an ASCII STL file, where any has a name.
std::vector<Group> named_solids(std::string_view text) {
  std::vector<Group> solids;
  Index n_facets = 0;
  bool has_name = false;
  TextScanner in(text);
  while (in.next_record()) {
    // Of the keywords that begin a line, or stand where one could, each has its first letters.
    const std::string_view word = in.word();
    if (word.size() == 5 && (word[0] == 's' || word[0] == 'S')) {
      solids.push_back({in.rest_of_record(), n_facets});
      has_name = has_name || !solids.back().name.empty();
    } else if (word.size() == 8 && (word[3] == 's' || word[3] == 'S')) {
      in.skip_record();  // endsolid, whose name may be any words
    } else if (word.size() == 8 && (word[3] == 'f' || word[3] == 'F')) {
      ++n_facets;
    }
  }
  return has_name ? solids : std::vector<Group>{};
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
      attributes.faces = inria_faces(bytes);
      return attributes;
    case Format::Stl:
      if (!is_binary(bytes, Format::Stl)) {
        attributes.solids = named_solids(bytes);
      }
      return attributes;
    case Format::Mesh:
      break;
  }
  return attributes;
}

/// The comments and notes in the header of a PLY file.
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

/// The comments before an offset of a text.
std::vector<std::string> comments_before(std::string_view text, std::size_t end) {
  std::vector<std::string> comments;
  for (std::size_t at = 0; at < end;) {
    const std::size_t line_end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, line_end - at);
    const std::size_t mark = line.find('#');
    // In a name, # begins no comment.
    if (mark == 0 || (mark != std::string_view::npos &&
                      std::string_view(" \t").find(line[mark - 1]) != std::string_view::npos)) {
      comments.emplace_back(line.substr(mark + 1, line.find_last_not_of(" \t\r") - mark));
    }
    at = line_end + 1;
  }
  return comments;
}

/// Where the line of the first record of a text begins.
std::size_t first_record(const Soup& soup, std::string_view text) {
  std::size_t line = soup.vertex_lines.empty() ? 1 : soup.vertex_lines.front();
  if (!soup.face_lines.empty()) {
    line = std::min<std::size_t>(line, soup.face_lines.front());
  }
  std::size_t begin = 0;
  for (std::size_t l = 1; l < line; ++l) {
    begin = text.find('\n', begin) + 1;
  }
  return begin;
}

/// Forgets colours that are no numbers: no format says them but as text.
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
