#include "meshalyzer/report/html/scene_json.h"

#include "meshalyzer/base/base64.h"
#include "meshalyzer/base/bytes.h"
#include "meshalyzer/report/html/colour_text.h"
#include "meshalyzer/report/json/writer.h"
#include "meshalyzer/report/text/defect_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::size_t kPaletteEntries = 256;

/// Writes JSON for a script element piece by piece, so that the whole text is never held twice.
class ScriptJson {
 public:
  explicit ScriptJson(std::string& html) : html_(html) {}

  [[nodiscard]] JsonWriter& writer() { return writer_; }

  /// Moves the written text into the page. Strings are not divided, so that no sequence of bytes
  /// that must be escaped is in two pieces.
  void flush() {
    const std::string drained = writer_.drain();
    const std::string_view text = drained;
    std::size_t written = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '<' && text[i] != '\xE2') continue;
      const std::string_view escape = escape_of(text.substr(i));
      if (escape.empty()) continue;
      html_ += text.substr(written, i - written);
      html_ += escape;
      written = i + (text[i] == '<' ? 1 : 3);
    }
    html_ += text.substr(written);
  }

 private:
  static std::string_view escape_of(std::string_view text) {
    if (text.starts_with('<')) return "\\u003c";
    if (text.starts_with("\xE2\x80\xA8")) return "\\u2028";
    if (text.starts_with("\xE2\x80\xA9")) return "\\u2029";
    return "";
  }

  std::string& html_;
  JsonWriter writer_;
};

void write_bytes_of(JsonWriter& json, std::string_view name, std::string_view bytes) {
  std::string text;
  append_base64(text, bytes);
  json.member(name, text);
}

template <typename Number>
void write_numbers(ScriptJson& json, std::string_view name, const std::vector<Number>& numbers) {
  std::string bytes;
  bytes.reserve(sizeof(Number) * numbers.size());
  for (const Number number : numbers) append_little_endian(bytes, number);
  write_bytes_of(json.writer(), name, bytes);
  json.flush();
}

/// Writes the values of a field; if all are equal, only the first one.
void write_values(ScriptJson& json, std::string_view name, const std::vector<float>& values) {
  const auto is_first = [&](float value) {
    return std::bit_cast<std::uint32_t>(value) == std::bit_cast<std::uint32_t>(values.front());
  };
  const bool is_uniform = std::all_of(values.begin(), values.end(), is_first);
  write_numbers(json, name, is_uniform && !values.empty() ? std::vector{values.front()} : values);
}

/// Returns the coordinates of unit vectors as whole numbers, with 127 for 1, which is enough for
/// shading.
std::vector<std::int8_t> short_normals(const std::vector<float>& normals) {
  std::vector<std::int8_t> shortened;
  shortened.reserve(normals.size());
  for (const float x : normals) {
    shortened.push_back(static_cast<std::int8_t>(std::lround(127.0F * std::clamp(x, -1.0F, 1.0F))));
  }
  return shortened;
}

template <typename Colours>
void write_palette(JsonWriter& json, std::string_view name, Colours colour_at) {
  std::string bytes;
  for (std::size_t i = 0; i < kPaletteEntries; ++i) {
    const Colour colour = colour_at(i);
    for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) {
      append_little_endian(bytes, channel);
    }
  }
  write_bytes_of(json, name, bytes);
}

void write_palettes(JsonWriter& json) {
  json.key("palettes");
  json.begin_object();
  for (const Palette palette : all_palettes()) {
    write_palette(json, palette_name(palette), [&](std::size_t i) {
      return colour_of(palette, static_cast<double>(i) / (kPaletteEntries - 1));
    });
  }
  write_palette(json, "category", [](std::size_t i) { return category_colour(i); });
  json.end_object();
}

void write_codes(JsonWriter& json) {
  json.key("codes");
  json.begin_array();
  for (const DefectCode code : all_defect_codes()) {
    json.begin_object(JsonLayout::Row);
    json.member("code", defect_name(code));
    json.member("colour", colour_text(code));
    json.end_object();
  }
  json.end_array();
}

/// Returns the ids in the file.
std::vector<std::int32_t> ids_of(const Ids& ids, const std::vector<Index>& records) {
  std::vector<std::int32_t> named;
  named.reserve(records.size());
  for (const Index record : records) named.push_back(static_cast<std::int32_t>(ids.of(record)));
  return named;
}

void write_surface(ScriptJson& json, std::string_view key, const DrawnSurface& surface,
                   const MeshName& name) {
  json.writer().key(key);
  json.writer().begin_object();
  write_numbers(json, "positions", surface.positions);
  write_numbers(json, "normals", short_normals(surface.normals));
  write_numbers(json, "triangles", surface.triangles);
  write_numbers(json, "vertex_ids", ids_of(name.vertex_ids, surface.vertices));
  write_numbers(json, "face_ids", ids_of(name.face_ids, surface.faces));
  json.writer().end_object();
}

std::string_view field_kind_name(FieldKind kind) {
  switch (kind) {
    case FieldKind::Signed:
      return "signed";
    case FieldKind::Category:
      return "category";
    case FieldKind::Magnitude:
      break;
  }
  return "magnitude";
}

void write_field(ScriptJson& json, const DrawnField& field, bool has_context) {
  JsonWriter& writer = json.writer();
  writer.begin_object();
  writer.member("name", field_name(field.name));
  writer.member("label", field_label(field.name));
  writer.member("place", field.place == FieldPlace::Vertices ? "vertices" : "faces");
  writer.member("kind", field_kind_name(field.kind));
  writer.member("palette", palette_name(field.scale.palette));
  writer.key("scale");
  writer.array(std::array{field.scale.min, field.scale.max});
  writer.key("range");
  writer.array(std::array{field.min, field.max});
  write_values(json, "detail", field.detail);
  if (has_context) {
    write_values(json, "context", field.context);
  } else {
    writer.key("context");
    writer.null();
  }
  writer.end_object();
}

void write_lines(ScriptJson& json, const SceneLines& lines) {
  json.writer().key("lines");
  json.writer().begin_object();
  write_numbers(json, "borders", lines.borders);
  write_numbers(json, "non_manifold_edges", lines.non_manifold_edges);
  write_numbers(json, "flipped_edges", lines.flipped_edges);
  write_numbers(json, "intersections", lines.intersections);
  json.writer().end_object();
}

void write_highlight(ScriptJson& json, const Highlight& highlight, std::string_view name,
                     std::string_view text) {
  JsonWriter& writer = json.writer();
  writer.begin_object();
  writer.member("code", name);
  writer.member("text", text);
  write_numbers(json, "faces", highlight.faces);
  write_numbers(json, "segments", highlight.segments);
  write_numbers(json, "points", highlight.points);
  writer.key("focus");
  writer.array(highlight.focus);
  writer.member("radius", highlight.radius);
  writer.member("cut", highlight.is_cut);
  writer.end_object();
}

/// Writes the highlights of the defects, then those of the changes.
void write_highlights(ScriptJson& json, const PageMesh& mesh) {
  json.writer().key("highlights");
  json.writer().begin_array();
  for (const Highlight& highlight : mesh.scene.highlights) {
    const Defect& defect = mesh.defects.defects[highlight.number];
    write_highlight(json, highlight, defect_name(defect.code),
                    listed_defect_text(defect, mesh.name));
  }
  for (const Highlight& highlight : mesh.scene.changes) {
    const PageChange& change = mesh.changes[highlight.number];
    write_highlight(json, highlight, change.pass, change.text);
  }
  json.writer().end_array();
}

void write_scene(ScriptJson& json, const TitledMesh& titled) {
  JsonWriter& writer = json.writer();
  const Scene& scene = titled.mesh.scene;
  const bool has_context = scene.context.n_faces() != 0;
  writer.begin_object();
  writer.member("title", titled.title);
  writer.key("centre");
  writer.array(scene.centre);
  writer.member("radius", scene.radius);
  writer.member("scale", scene.scale);
  writer.key("notes");
  writer.array(scene.notes, JsonLayout::Lines);
  writer.member("faces", scene.n_faces);
  writer.member("decimated", scene.n_decimated);
  write_surface(json, "detail", scene.detail, titled.mesh.name);
  if (has_context) {
    write_surface(json, "context", scene.context, titled.mesh.name);
  } else {
    writer.key("context");
    writer.null();
  }
  writer.key("fields");
  writer.begin_array();
  for (const DrawnField& field : scene.fields) write_field(json, field, has_context);
  writer.end_array();
  write_lines(json, scene.lines);
  writer.member("defects", scene.highlights.size());
  write_highlights(json, titled.mesh);
  writer.end_object();
}

}  // namespace

std::string listed_defect_text(const Defect& defect, const MeshName& mesh) {
  std::string text = defect_text(defect, mesh, ListLength::Short);
  if (text.empty()) text = defect_name(defect.code);
  return text;
}

void append_scene_json(std::string& html, std::span<const TitledMesh> meshes) {
  ScriptJson json(html);
  json.writer().begin_object();
  write_palettes(json.writer());
  write_codes(json.writer());
  json.writer().key("scenes");
  json.writer().begin_array();
  for (const TitledMesh& mesh : meshes) write_scene(json, mesh);
  json.writer().end_array();
  json.writer().end_object();
  json.flush();
}

}  // namespace meshalyzer
