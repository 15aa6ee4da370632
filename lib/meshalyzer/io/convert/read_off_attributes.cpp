#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/convert/read_attributes.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/off_records.h"
#include "meshalyzer/io/rewrite/text_lines.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

using Words = std::vector<std::string_view>;

/// Reads a colour of three or four numbers in the words from `begin` to before `end`; they are
/// bytes if all are whole. A single number is an index into a table that the file does not hold.
std::optional<Rgba> read_colour(const Words& words, std::size_t begin, std::size_t end) {
  if (end < begin + 3) {
    return std::nullopt;
  }
  const bool are_bytes =
      std::all_of(words.begin() + static_cast<std::ptrdiff_t>(begin),
                  words.begin() + static_cast<std::ptrdiff_t>(end),
                  [](std::string_view w) { return parse_integer(w).has_value(); });
  Rgba colour{0.0, 0.0, 0.0, 1.0};
  for (std::size_t i = begin; i < end; ++i) {
    colour[i - begin] = parse_real(words[i]).value_or(0.0) / (are_bytes ? 255.0 : 1.0);
  }
  return colour;
}

}  // namespace

MeshAttributes read_off_attributes(const Soup& soup, std::string_view text) {
  MeshAttributes attributes;
  const OffRecords records = find_off_records(text, soup.n_vertices());
  attributes.faces = records.face_records;
  const std::size_t n_own = has_vertex_normals(soup) ? 6 : 3;
  const std::size_t n_texture = records.layout.texture ? 2 : 0;
  std::vector<TexturePoint> texture_points;
  for (std::size_t v = 0; v < records.vertices.size(); ++v) {
    const Words words = words_at(text, records.vertices[v], Continuation::None);
    const std::size_t colour_end = words.size() - n_texture;
    if (const std::optional<Rgba> colour = read_colour(words, n_own, colour_end)) {
      attributes.vertex_colours.resize(records.vertices.size());
      attributes.vertex_colours[v] = colour;
    }
    if (records.layout.texture) {
      texture_points.push_back({parse_real(words[colour_end]).value_or(0.0),
                                parse_real(words[colour_end + 1]).value_or(0.0)});
    }
  }
  for (std::size_t r = 0; r < records.faces.size(); ++r) {
    const Words words = words_at(text, records.faces[r], Continuation::None);
    const auto n_corners = static_cast<std::size_t>(parse_integer(words[0]).value_or(0));
    if (const auto colour = read_colour(words, 1 + n_corners, words.size())) {
      attributes.face_colours.resize(records.faces.size());
      attributes.face_colours[r] = colour;
    }
  }
  use_at_corners(attributes, soup, texture_points);
  return attributes;
}

}  // namespace meshalyzer
