#include "meshalyzer/base/bytes.h"
#include "meshalyzer/io/field_formats.h"

#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

constexpr std::size_t kValueBytes = sizeof(double) + 3;
constexpr std::size_t kVertexBytes = 3 * sizeof(double) + kValueBytes;
constexpr std::size_t kFaceBytes = 1 + 3 * sizeof(std::int32_t);

constexpr std::string_view kValueProperties =
    "property double quality\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n";

std::string print_header(const MeshField& field) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : field.comments) {
    text.append("comment ").append(comment) += '\n';
  }
  text += "element vertex " + std::to_string(field.positions.size()) + '\n';
  text += "property double x\nproperty double y\nproperty double z\n";
  text += kValueProperties;
  text += "element face " + std::to_string(field.triangles.size()) + '\n';
  text += "property list uchar int vertex_indices\n";
  if (!field.faces.values.empty()) {
    text += kValueProperties;
  }
  return text + "end_header\n";
}

void append_value(std::string& content, const ColouredValues& column, std::size_t i) {
  append_little_endian(content, column.values[i]);
  append_little_endian(content, column.colours[i].red);
  append_little_endian(content, column.colours[i].green);
  append_little_endian(content, column.colours[i].blue);
}

}  // namespace

std::string print_ply_field(const MeshField& field) {
  std::string content = print_header(field);
  content.reserve(content.size() + kVertexBytes * field.positions.size() +
                  kFaceBytes * field.triangles.size() + kValueBytes * field.faces.values.size());
  for (std::size_t v = 0; v < field.positions.size(); ++v) {
    for (const double coordinate : field.positions[v]) {
      append_little_endian(content, coordinate);
    }
    append_value(content, field.vertices, v);
  }
  for (std::size_t f = 0; f < field.triangles.size(); ++f) {
    append_little_endian(content, std::uint8_t{3});
    for (const Index corner : field.triangles[f]) {
      append_little_endian(content, static_cast<std::int32_t>(corner));
    }
    if (!field.faces.values.empty()) {
      append_value(content, field.faces, f);
    }
  }
  return content;
}

}  // namespace meshalyzer
