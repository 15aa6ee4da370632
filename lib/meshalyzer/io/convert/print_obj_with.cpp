#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/convert/print_attributes.h"
#include "meshalyzer/io/print_record.h"

#include <cstdint>
#include <map>

namespace meshalyzer {
namespace {

class ObjPrinter {
 public:
  ObjPrinter(const MeshAttributes& attributes, const Soup& soup)
      : attributes_(attributes), soup_(soup) {}

  std::string print() {
    for (const std::string& comment : attributes_.comments) {
      text_ += '#' + comment + '\n';
    }
    for (std::size_t v = 0; v < soup_.n_vertices(); ++v) {
      print_vertex(v);
    }
    print_texture();
    for (const Vec3& normal : soup_.normals) {
      print_record(text_, "vn", normal);
    }
    auto solid = attributes_.solids.begin();
    for (Index r = 0; r < attributes_.faces.size(); ++r) {
      for (; solid != attributes_.solids.end() &&
             solid->first_face <= attributes_.faces.first_triangle[r];
           ++solid) {
        text_ += "g " + solid->name + '\n';
      }
      print_face(r);
    }
    return std::move(text_);
  }

 private:
  void print_vertex(std::size_t v) {
    print_record(text_, "v", soup_.positions[v]);
    if (!attributes_.vertex_colours.empty() && attributes_.vertex_colours[v]) {
      text_.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        text_ += ' ';
        append_shortest(text_, (*attributes_.vertex_colours[v])[i]);
      }
      text_ += '\n';
    }
  }

  /// Prints the texture coordinates; equal ones become one record.
  void print_texture() {
    for (const std::optional<TexturePoint>& point : attributes_.texture) {
      if (point && texture_numbers_.emplace(*point, texture_numbers_.size() + 1).second) {
        text_ += "vt ";
        append_shortest(text_, (*point)[0]);
        text_ += ' ';
        append_shortest(text_, (*point)[1]);
        text_ += '\n';
      }
    }
  }

  void print_face(Index record) {
    text_ += 'f';
    const std::vector<Index> corners = corners_of(attributes_.faces, soup_, record);
    const std::size_t first = first_corner(attributes_.faces, record);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const bool is_missing = corners[i] == kNoIndex;
      text_ += ' ' + std::to_string(is_missing ? 1 : std::uint64_t{corners[i]} + 1);
      const bool has_texture = !attributes_.texture.empty() && attributes_.texture[first + i];
      if (has_texture) {
        text_ += '/' + std::to_string(texture_numbers_.at(*attributes_.texture[first + i]));
      }
      const FanCorner corner = fan_corner(attributes_.faces, record, i);
      const Index normal = soup_.corner_normals.empty()
                               ? kNoIndex
                               : soup_.corner_normals[corner.triangle][corner.corner];
      if (normal != kNoIndex) {
        text_ += has_texture ? "/" : "//";
        text_ += std::to_string(std::uint64_t{normal} + 1);
      }
    }
    text_ += '\n';
  }

  const MeshAttributes& attributes_;
  const Soup& soup_;
  std::map<TexturePoint, std::size_t> texture_numbers_;
  std::string text_;
};

}  // namespace

std::string print_obj_with(const MeshAttributes& attributes, const Soup& soup) {
  return ObjPrinter(attributes, soup).print();
}

}  // namespace meshalyzer
