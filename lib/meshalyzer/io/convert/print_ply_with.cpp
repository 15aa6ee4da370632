#include "meshalyzer/base/bytes.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/convert/print_attributes.h"
#include "meshalyzer/io/references.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

/// The records of a file, number by number.
class PlyRecordsText {
 public:
  explicit PlyRecordsText(Encoding encoding) : is_text_(encoding == Encoding::Text) {}

  template <typename Number>
  void append(Number number) {
    if (is_text_) {
      append_shortest(content_, static_cast<double>(number));
      content_ += ' ';
    } else {
      append_little_endian(content_, number);
    }
  }
  /// Appends a number that binary files hold in 32 bits; as text it keeps its precision.
  void append_real(double number) {
    if (is_text_) {
      append(number);
    } else {
      append(static_cast<float>(number));
    }
  }
  void end_record() {
    if (is_text_) {
      content_.back() = '\n';
    }
  }
  [[nodiscard]] std::string& content() { return content_; }

 private:
  bool is_text_;
  std::string content_;
};

/// Colours as they are written.
struct PlyColours {
  explicit PlyColours(const std::vector<std::optional<Rgba>>& all)
      : colours(all), n_parts(have_opacity(all) ? 4 : 3), in_bytes(are_bytes(all)) {}

  const std::vector<std::optional<Rgba>>& colours;
  std::size_t n_parts;
  bool in_bytes;

  [[nodiscard]] std::string declarations() const {
    constexpr std::array<std::string_view, 4> kNames = {"red", "green", "blue", "alpha"};
    std::string text;
    for (std::size_t i = 0; !colours.empty() && i < n_parts; ++i) {
      text += in_bytes ? "property uchar " : "property float ";
      text += kNames[i];
      text += '\n';
    }
    return text;
  }

  void append(std::size_t element, PlyRecordsText& body) const {
    const Rgba white{1.0, 1.0, 1.0, 1.0};
    for (std::size_t i = 0; !colours.empty() && i < n_parts; ++i) {
      const double part = colours[element].value_or(white)[i];
      if (in_bytes) {
        body.append(static_cast<std::uint8_t>(std::round(part * 255.0)));
      } else {
        body.append_real(part);
      }
    }
  }
};

class PlyPrinter {
 public:
  PlyPrinter(const MeshAttributes& attributes, const Soup& soup, Encoding encoding)
      : attributes_(attributes),
        soup_(soup),
        encoding_(encoding),
        has_normals_(has_vertex_normals(soup)),
        vertex_colours_(attributes.vertex_colours),
        face_colours_(attributes.face_colours),
        body_(encoding) {
    Index largest = 0;
    for (Index r = 0; r < attributes.faces.size(); ++r) {
      largest = std::max(largest, static_cast<Index>(attributes.faces.n_triangles(r) + 2));
    }
    constexpr Index kLargestByte = 255;
    has_large_faces_ = 2 * largest > kLargestByte;
  }

  std::string print() {
    for (std::size_t v = 0; v < soup_.n_vertices(); ++v) {
      print_vertex(v);
    }
    for (Index r = 0; r < attributes_.faces.size(); ++r) {
      print_face(r);
    }
    return header() + body_.content();
  }

 private:
  [[nodiscard]] std::string header() const {
    const std::string size_type = has_large_faces_ ? "int" : "uchar";
    std::string text = "ply\nformat ";
    text += encoding_ == Encoding::Text ? "ascii 1.0\n" : "binary_little_endian 1.0\n";
    for (const std::string& comment : attributes_.comments) {
      text += "comment" + std::string(comment.substr(0, 1) == " " ? "" : " ") + comment + '\n';
    }
    text += "element vertex " + std::to_string(soup_.n_vertices()) +
            "\nproperty double x\nproperty double y\nproperty double z\n";
    text += has_normals_ ? "property double nx\nproperty double ny\nproperty double nz\n" : "";
    text += vertex_colours_.declarations();
    text += declaration_of(attributes_.vertex_references);
    text += "element face " + std::to_string(attributes_.faces.size()) + "\nproperty list " +
            size_type + " int vertex_indices\n";
    text += face_colours_.declarations();
    text += declaration_of(attributes_.face_references);
    text += attributes_.attribute_words.empty() ? "" : "property ushort attribute\n";
    text += attributes_.texture.empty() ? "" : "property list " + size_type + " float texcoord\n";
    return text + "end_header\n";
  }

  void print_vertex(std::size_t v) {
    for (const double coordinate : soup_.positions[v]) {
      body_.append(coordinate);
    }
    if (has_normals_) {
      for (const double coordinate : soup_.normals[v]) {
        body_.append(coordinate);
      }
    }
    vertex_colours_.append(v, body_);
    append_reference(attributes_.vertex_references, v);
    body_.end_record();
  }

  [[nodiscard]] static std::string declaration_of(const std::vector<std::int32_t>& references) {
    return references.empty() ? "" : "property int reference\n";
  }

  void append_reference(const std::vector<std::int32_t>& references, std::size_t element) {
    if (!references.empty()) body_.append(references[element]);
  }

  void append_size(std::size_t n) {
    if (has_large_faces_) {
      body_.append(static_cast<std::int32_t>(n));
    } else {
      body_.append(static_cast<std::uint8_t>(n));
    }
  }

  void print_face(Index record) {
    const std::vector<Index> corners = corners_of(attributes_.faces, soup_, record);
    append_size(corners.size());
    for (const Index corner : corners) {
      body_.append(static_cast<std::int32_t>(corner == kNoIndex ? 0 : corner));
    }
    face_colours_.append(record, body_);
    append_reference(attributes_.face_references, record);
    if (!attributes_.attribute_words.empty()) {
      body_.append(attributes_.attribute_words[record]);
    }
    if (!attributes_.texture.empty()) {
      print_texture(record, corners.size());
    }
    body_.end_record();
  }

  void print_texture(Index record, std::size_t n_corners) {
    const std::size_t first = first_corner(attributes_.faces, record);
    const bool has_texture = attributes_.texture[first].has_value();
    append_size(has_texture ? 2 * n_corners : 0);
    for (std::size_t i = 0; has_texture && i < n_corners; ++i) {
      for (const double number : *attributes_.texture[first + i]) {
        body_.append_real(number);
      }
    }
  }

  const MeshAttributes& attributes_;
  const Soup& soup_;
  Encoding encoding_;
  bool has_normals_;
  PlyColours vertex_colours_;
  PlyColours face_colours_;
  PlyRecordsText body_;
  bool has_large_faces_ = false;
};

}  // namespace

std::string print_ply_with(const MeshAttributes& attributes, const Soup& soup, Encoding encoding) {
  return PlyPrinter(attributes, soup, encoding).print();
}

}  // namespace meshalyzer
