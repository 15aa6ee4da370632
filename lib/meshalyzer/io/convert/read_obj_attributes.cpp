#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/convert/read_attributes.h"
#include "meshalyzer/io/rewrite/obj_records.h"
#include "meshalyzer/io/rewrite/text_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using Words = std::vector<std::string_view>;

class ObjAttributeReader {
 public:
  explicit ObjAttributeReader(std::string_view text)
      : text_(text), records_(find_obj_records(text)) {}

  MeshAttributes read() {
    attributes_.faces.first_triangle = records_.face_records.first_triangle;
    read_colours();
    read_texture();
    return std::move(attributes_);
  }

 private:
  [[nodiscard]] Words words(std::size_t statement) const {
    return words_at(text_, statement, Continuation::Backslash);
  }

  /// Reads the colours of vertices: a colour follows the position or, if there are seven numbers,
  /// the weight.
  void read_colours() {
    constexpr std::size_t kShortest = 7;
    auto& colours = attributes_.vertex_colours;
    bool has_bytes = false;
    for (std::size_t v = 0; v < records_.vertices.size(); ++v) {
      const Words all = words(records_.vertices[v]);
      if (all.size() < kShortest) {
        continue;
      }
      colours.resize(records_.vertices.size());
      Rgba& colour = colours[v].emplace(Rgba{0.0, 0.0, 0.0, 1.0});
      bool is_whole = true;
      for (std::size_t i = 0; i < 3; ++i) {
        colour[i] = parse_real(all[all.size() - 3 + i]).value_or(0.0);
        is_whole = is_whole && colour[i] == std::round(colour[i]);
      }
      has_bytes = has_bytes || (is_whole && *std::max_element(colour.begin(), colour.end()) > 1.0);
    }
    // Some programs write colours as bytes; a number slightly above 1 is none.
    const double scale = has_bytes ? 255.0 : 1.0;
    for (std::optional<Rgba>& colour : colours) {
      for (std::size_t i = 0; colour && i < 3; ++i) {
        (*colour)[i] /= scale;
      }
    }
  }

  void read_texture() {
    if (records_.texture_points.empty()) {
      return;
    }
    const FaceRecords& faces = attributes_.faces;
    attributes_.texture.resize(first_corner(faces, static_cast<Index>(faces.size())));
    std::vector<std::optional<TexturePoint>> points;
    points.reserve(records_.texture_points.size());
    for (const std::size_t statement : records_.texture_points) {
      points.push_back(read_texture_point(statement));
    }
    std::vector<Use> uses(points.size(), Use::None);
    bool has_texture = false;
    for (Index r = 0; r < faces.size(); ++r) {
      has_texture = read_texture_of_face(r, points, uses) || has_texture;
    }
    attributes_.n_texture_points =
        static_cast<std::size_t>(std::count(uses.begin(), uses.end(), Use::Held));
    if (!has_texture) {
      attributes_.texture.clear();
    }
  }

  /// What becomes of a texture point: no face names it, all that do keep it, or one does not.
  enum class Use : std::uint8_t { None, Held, Lost };

  /// Reads the texture coordinates of a face, which has them at all corners or at none. Returns
  /// true if it has them.
  bool read_texture_of_face(Index record, const std::vector<std::optional<TexturePoint>>& points,
                            std::vector<Use>& uses) {
    const Words all = words(records_.faces[record]);
    const ObjCounts counts = records_.counts_before(records_.faces[record]);
    std::vector<Index> named;
    bool is_whole = true;
    for (std::size_t i = 1; i < all.size(); ++i) {
      named.push_back(parse_obj_corner(all[i], counts, TextScanner(all[i])).texture_point);
      is_whole = is_whole && named.back() < points.size() && points[named.back()];
    }
    for (const Index point : named) {
      if (point < points.size() && uses[point] != Use::Lost) {
        uses[point] = is_whole ? Use::Held : Use::Lost;
      }
    }
    if (!is_whole) {
      return false;
    }
    const std::size_t first = first_corner(attributes_.faces, record);
    const std::size_t n = attributes_.faces.n_triangles(record) + 2;
    for (std::size_t i = 0; i < n; ++i) {
      attributes_.texture[first + i] = points[named[std::min(i, named.size() - 1)]];
    }
    return true;
  }

  /// Returns a texture point, or nothing if it has three numbers, which no other format can hold.
  [[nodiscard]] std::optional<TexturePoint> read_texture_point(std::size_t statement) const {
    const Words all = words(statement);
    const auto number = [&](std::size_t i) {
      return i < all.size() ? parse_real(all[i]).value_or(0.0) : 0.0;
    };
    return number(3) == 0.0 ? std::optional(TexturePoint{number(1), number(2)}) : std::nullopt;
  }

  std::string_view text_;
  ObjRecords records_;
  MeshAttributes attributes_;
};

}  // namespace

MeshAttributes read_obj_attributes(std::string_view text) {
  return ObjAttributeReader(text).read();
}

}  // namespace meshalyzer
