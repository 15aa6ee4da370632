#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/convert/read_attributes.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/off_records.h"
#include "meshalyzer/io/rewrite/text_lines.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

using Words = std::vector<std::string_view>;

/// The colours of the vertices or faces of a file, read one by one.
class OffColours {
 public:
  explicit OffColours(std::size_t n_elements) : n_elements_(n_elements) {}

  /// Reads a colour of three or four numbers. A single number is an index into a table that the
  /// file does not hold.
  void read(std::size_t element, std::span<const std::string_view> words) {
    if (words.size() < 3) {
      return;
    }
    colours_.resize(n_elements_);
    Colour& colour = colours_[element].emplace();
    for (const std::string_view word : words) {
      colour.numbers[colour.n_numbers++] = parse_real(word).value_or(0.0);
      colour.is_whole = colour.is_whole && parse_integer(word).has_value();
    }
    has_bytes_ = has_bytes_ || is_byte_colour(words);
  }

  /// Returns the colours as intensities; empty if there is none.
  [[nodiscard]] std::vector<std::optional<Rgba>> intensities() const {
    std::vector<std::optional<Rgba>> all(colours_.size());
    for (std::size_t element = 0; element < all.size(); ++element) {
      if (const std::optional<Colour>& colour = colours_[element]) {
        all[element] = colour->numbers;
        const double full = has_bytes_ && colour->is_whole ? 255.0 : 1.0;
        for (std::size_t i = 0; i < colour->n_numbers; ++i) (*all[element])[i] /= full;
      }
    }
    return all;
  }

 private:
  struct Colour {
    Rgba numbers{0.0, 0.0, 0.0, 1.0};
    std::size_t n_numbers = 0;
    bool is_whole = true;
  };
  std::size_t n_elements_;
  std::vector<std::optional<Colour>> colours_;
  bool has_bytes_ = false;
};

}  // namespace

MeshAttributes read_off_attributes(const Soup& soup, std::string_view text) {
  MeshAttributes attributes;
  const OffRecords records = find_off_records(text, soup.n_vertices());
  attributes.faces = records.face_records;
  const std::size_t n_own = has_vertex_normals(soup) ? 6 : 3;
  const std::size_t n_texture = records.layout.texture ? 2 : 0;
  std::vector<TexturePoint> texture_points;
  OffColours of_vertices(records.vertices.size());
  for (std::size_t v = 0; v < records.vertices.size(); ++v) {
    const Words words = words_at(text, records.vertices[v], Continuation::None);
    const std::size_t colour_end = words.size() - n_texture;
    of_vertices.read(v, std::span(words).subspan(n_own, colour_end - n_own));
    if (records.layout.texture) {
      texture_points.push_back({parse_real(words[colour_end]).value_or(0.0),
                                parse_real(words[colour_end + 1]).value_or(0.0)});
    }
  }
  OffColours of_faces(records.faces.size());
  for (std::size_t r = 0; r < records.faces.size(); ++r) {
    const Words words = words_at(text, records.faces[r], Continuation::None);
    const auto n_corners = static_cast<std::size_t>(parse_integer(words[0]).value_or(0));
    of_faces.read(r, std::span(words).subspan(1 + n_corners));
  }
  attributes.vertex_colours = of_vertices.intensities();
  attributes.face_colours = of_faces.intensities();
  use_at_corners(attributes, soup, texture_points);
  return attributes;
}

}  // namespace meshalyzer
