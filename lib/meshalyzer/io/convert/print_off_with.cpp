#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/convert/print_attributes.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/rewrite/off_records.h"

#include <cmath>
#include <utility>

namespace meshalyzer {
namespace {

class OffPrinter {
 public:
  OffPrinter(const MeshAttributes& attributes, const Soup& soup)
      : attributes_(attributes),
        soup_(soup),
        has_normals_(has_vertex_normals(soup)),
        in_bytes_(are_bytes(attributes.vertex_colours) && are_bytes(attributes.face_colours)),
        texture_(texture_of_vertices(attributes, soup)) {}

  std::string print() {
    text_ += texture_.empty() ? "" : "ST";
    text_ += attributes_.vertex_colours.empty() ? "" : "C";
    text_ += has_normals_ ? "NOFF\n" : "OFF\n";
    for (const std::string& comment : attributes_.comments) {
      text_ += '#' + comment + '\n';
    }
    text_ += std::to_string(soup_.n_vertices()) + ' ' + std::to_string(attributes_.faces.size()) +
             " 0\n";
    for (std::size_t v = 0; v < soup_.n_vertices(); ++v) {
      print_vertex(v);
    }
    for (Index r = 0; r < attributes_.faces.size(); ++r) {
      print_face(r);
    }
    return std::move(text_);
  }

 private:
  void append(double number) {
    append_shortest(text_, number);
    text_ += ' ';
  }

  void append_colour(const Rgba& colour) {
    for (const double part : colour) {
      text_ += in_bytes_ ? shortest(std::round(part * 255.0)) : off_intensity(part);
      text_ += ' ';
    }
  }

  void print_vertex(std::size_t v) {
    for (const double coordinate : soup_.positions[v]) {
      append(coordinate);
    }
    if (has_normals_) {
      for (const double coordinate : soup_.normals[v]) {
        append(coordinate);
      }
    }
    if (!attributes_.vertex_colours.empty()) {
      append_colour(attributes_.vertex_colours[v].value_or(Rgba{1.0, 1.0, 1.0, 1.0}));
    }
    if (!texture_.empty()) {
      append(texture_[v][0]);
      append(texture_[v][1]);
    }
    text_.back() = '\n';
  }

  void print_face(Index record) {
    const std::vector<Index> corners = corners_of(attributes_.faces, soup_, record);
    text_ += std::to_string(corners.size()) + ' ';
    for (const Index corner : corners) {
      text_ += std::to_string(corner == kNoIndex ? 0 : corner) + ' ';
    }
    if (!attributes_.face_colours.empty() && attributes_.face_colours[record]) {
      append_colour(*attributes_.face_colours[record]);
    }
    text_.back() = '\n';
  }

  const MeshAttributes& attributes_;
  const Soup& soup_;
  bool has_normals_;
  bool in_bytes_;
  std::vector<TexturePoint> texture_;
  std::string text_;
};

}  // namespace

std::string print_off_with(const MeshAttributes& attributes, const Soup& soup) {
  return OffPrinter(attributes, soup).print();
}

}  // namespace meshalyzer
