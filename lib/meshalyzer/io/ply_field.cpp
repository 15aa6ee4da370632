#include "meshalyzer/io/ply_field.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/bytes.h"

#include <algorithm>
#include <cstdint>

namespace meshalyzer {
namespace {

constexpr std::size_t kVertexBytes = 4 * sizeof(double) + 3;
constexpr std::size_t kFaceBytes = 1 + 3 * sizeof(std::int32_t);

void require_whole(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                   const VertexField& field) {
  if (field.values.size() != positions.size() || field.colours.size() != positions.size()) {
    throw InvalidArgument("a field that is not of as many vertices as the mesh");
  }
  const auto is_vertex = [&](Index corner) { return corner < positions.size(); };
  for (const Triangle& t : triangles) {
    if (!std::all_of(t.begin(), t.end(), is_vertex)) {
      throw InvalidArgument("a face has a corner without a vertex");
    }
  }
}

std::string print_header(std::size_t n_vertices, std::size_t n_faces) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  text += std::to_string(n_vertices) + '\n';
  for (const char* name : {"x", "y", "z", "quality"}) {
    text += std::string("property double ") + name + '\n';
  }
  for (const char* name : {"red", "green", "blue"}) {
    text += std::string("property uchar ") + name + '\n';
  }
  text += "element face " + std::to_string(n_faces) + '\n';
  return text + "property list uchar int vertex_indices\nend_header\n";
}

}  // namespace

std::string print_ply_field(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                            const VertexField& field) {
  require_whole(positions, triangles, field);
  std::string content = print_header(positions.size(), triangles.size());
  content.reserve(content.size() + kVertexBytes * positions.size() + kFaceBytes * triangles.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    for (const double coordinate : positions[v]) {
      append_little_endian(content, coordinate);
    }
    append_little_endian(content, field.values[v]);
    append_little_endian(content, field.colours[v].red);
    append_little_endian(content, field.colours[v].green);
    append_little_endian(content, field.colours[v].blue);
  }
  for (const Triangle& t : triangles) {
    append_little_endian(content, std::uint8_t{3});
    for (const Index corner : t) {
      append_little_endian(content, static_cast<std::int32_t>(corner));
    }
  }
  return content;
}

}  // namespace meshalyzer
