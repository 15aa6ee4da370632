#include "meshalyzer/io/convert/read_attributes.h"
#include "meshalyzer/io/ply_names.h"
#include "meshalyzer/io/rewrite/ply_records.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns the full intensity of a colour of this type.
double full_intensity(PlyType type) {
  if (!is_integer(type)) {
    return 1.0;
  }
  return type == PlyType::UInt16 ? 65535.0 : 255.0;
}

class PlyAttributeReader {
 public:
  PlyAttributeReader(const Soup& soup, std::string_view content, const PlyHeader& header)
      : soup_(soup), header_(header), records_(content, header) {}

  MeshAttributes read() {
    attributes_.faces = single_triangles(soup_.n_faces());
    for (std::size_t e = 0; e < header_.elements.size(); ++e) {
      // If some faces are strips, those of this element are only a part of all.
      if (header_.elements[e].name == "face" && !has_strips()) {
        read_faces(e);
      }
    }
    for (std::size_t e = 0; e < header_.elements.size(); ++e) {
      if (header_.elements[e].name == "vertex") {
        attributes_.vertex_colours = read_colours(e);
        read_vertex_texture(e);
      }
    }
    return std::move(attributes_);
  }

 private:
  [[nodiscard]] bool has_strips() const {
    return std::any_of(header_.elements.begin(), header_.elements.end(),
                       [](const PlyElement& element) { return element.name == "tristrips"; });
  }

  void read_faces(std::size_t element) {
    const std::vector<PlyProperty>& properties = header_.elements[element].properties;
    const std::size_t corners = find_corner_list(header_.elements[element]);
    attributes_.faces = face_records_of(records_, element, corners);
    attributes_.face_colours = read_colours(element);
    for (std::size_t p = 0; p < properties.size(); ++p) {
      if (is_one_of(properties[p].name, kPlyCornerTexture)) {
        read_corner_texture(element, p, corners);
      }
    }
  }

  [[nodiscard]] std::vector<std::optional<Rgba>> read_colours(std::size_t element) const {
    const PlyElement& declared = header_.elements[element];
    std::array<std::size_t, 4> places{};
    for (const std::array<std::string_view, 4>& names : kPlyColourNames) {
      for (std::size_t i = 0; i < 4; ++i) {
        places[i] = find_property(declared, names[i]);
      }
      if (std::max({places[0], places[1], places[2]}) < declared.properties.size()) {
        break;
      }
    }
    if (std::max({places[0], places[1], places[2]}) >= declared.properties.size()) {
      return {};
    }
    std::vector<std::optional<Rgba>> colours;
    for (std::size_t r = 0; r < records_.begins(element).size(); ++r) {
      const PlyRecord record = records_.read(element, r);
      Rgba& colour = colours.emplace_back().emplace(Rgba{0.0, 0.0, 0.0, 1.0});
      for (std::size_t i = 0; i < 4; ++i) {
        if (places[i] < declared.properties.size()) {
          const PlyType type = declared.properties[places[i]].type;
          colour[i] = number(record, places[i], type) / full_intensity(type);
        }
      }
    }
    return colours;
  }

  [[nodiscard]] double number(const PlyRecord& record, std::size_t property, PlyType type) const {
    const std::vector<std::string_view>& items = record.fields[property].items;
    return items.empty() ? 0.0 : records_.number(items[0], type);
  }

  /// Reads a list of two numbers for each corner.
  void read_corner_texture(std::size_t element, std::size_t property, std::size_t corners) {
    const PlyType type = header_.elements[element].properties[property].type;
    const FaceRecords& faces = attributes_.faces;
    attributes_.texture.assign(first_corner(faces, static_cast<Index>(faces.size())), std::nullopt);
    for (Index r = 0; r < faces.size(); ++r) {
      const PlyRecord record = records_.read(element, r);
      const std::vector<std::string_view>& items = record.fields[property].items;
      const std::size_t n = record.fields[corners].items.size();
      if (items.size() != 2 * n) {
        continue;
      }
      ++attributes_.n_texture_points;
      for (std::size_t i = 0; i < faces.n_triangles(r) + 2; ++i) {
        const std::size_t at = 2 * std::min(i, n - 1);
        attributes_.texture[first_corner(faces, r) + i] = {records_.number(items[at], type),
                                                           records_.number(items[at + 1], type)};
      }
    }
  }

  void read_vertex_texture(std::size_t element) {
    const PlyElement& declared = header_.elements[element];
    for (const auto& [u_name, v_name] : kPlyVertexTexture) {
      const std::size_t u = find_property(declared, u_name);
      const std::size_t v = find_property(declared, v_name);
      if (std::max(u, v) >= declared.properties.size() || !attributes_.texture.empty()) {
        continue;
      }
      std::vector<TexturePoint> points;
      for (std::size_t r = 0; r < records_.begins(element).size(); ++r) {
        const PlyRecord record = records_.read(element, r);
        points.push_back({number(record, u, declared.properties[u].type),
                          number(record, v, declared.properties[v].type)});
      }
      use_at_corners(attributes_, soup_, points);
    }
  }

  const Soup& soup_;
  const PlyHeader& header_;
  PlyRecords records_;
  MeshAttributes attributes_;
};

}  // namespace

MeshAttributes read_ply_attributes(const Soup& soup, std::string_view content) {
  const PlyHeader header = parse_ply_header(content);
  return PlyAttributeReader(soup, content, header).read();
}

}  // namespace meshalyzer
