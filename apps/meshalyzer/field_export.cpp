#include "field_export.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/mesh_field.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

FieldFormat format_of(const std::string& file) {
  const std::optional<FieldFormat> format = field_format_of_name(file);
  if (!format) {
    throw InvalidArgument("'" + file + "' has the ending of no format that holds a field");
  }
  return *format;
}

/// The faces that have all corners, and their values.
struct DrawnFaces {
  std::vector<Triangle> triangles;
  /// The values; empty for a field of vertices.
  std::vector<double> values;
};

DrawnFaces drawn_faces(const Soup& soup, const Field& field) {
  DrawnFaces drawn;
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (std::find(t.begin(), t.end(), kNoIndex) != t.end()) {
      continue;
    }
    drawn.triangles.push_back(t);
    if (field.place == FieldPlace::Faces) {
      drawn.values.push_back(field.values[f]);
    }
  }
  return drawn;
}

std::vector<Colour> colour(const FieldColours& colours, const std::vector<double>& values) {
  std::vector<Colour> result(values.size());
  std::transform(values.begin(), values.end(), result.begin(),
                 [&](double value) { return colours.of(value); });
  return result;
}

std::string range_text(double min, double max) {
  return shortest(min) + " to " + shortest(max);
}

std::string values_text(const std::vector<double>& values) {
  const std::optional<std::pair<double, double>> range = finite_range(values);
  return range ? range_text(range->first, range->second) : "none";
}

std::vector<std::string> comments_on(const ColouredField& field) {
  std::vector<std::string> comments(3);
  comments[0].append("field ").append(field_name(field.field.name)).append(field.remark);
  comments[1].append("values ").append(values_text(field.field.values));
  comments[2] = "colours one a category";
  if (const std::optional<ColourScale>& scale = field.colours.scale) {
    comments[2] = "colours ";
    comments[2].append(palette_name(scale->palette)).append(" from ");
    comments[2] += range_text(scale->min, scale->max);
  }
  return comments;
}

/// Returns the area of Gaussian and mean curvature in words.
std::string remark_on(const FieldSource& source, FieldName name) {
  std::string remark;
  if (name == FieldName::Gaussian || name == FieldName::Mean) {
    remark.append(" over ").append(area_name(source.area)).append(" areas");
  }
  return remark;
}

}  // namespace

void write_field(const std::string& file, const ColouredField& field) {
  const FieldFormat format = format_of(file);
  const DrawnFaces faces = drawn_faces(field.soup, field.field);
  const std::vector<double> values = at_vertices(field.field, field.soup);
  const std::vector<Colour> colours = colour(field.colours, values);
  const std::vector<Colour> face_colours = colour(field.colours, faces.values);
  const MeshField written{.positions = field.soup.positions,
                          .triangles = faces.triangles,
                          .name = field_name(field.field.name),
                          .vertices = {values, colours},
                          .faces = {faces.values, face_colours},
                          .comments = comments_on(field)};
  replace_file(file, print_mesh_field(written, format));
}

void write_field(const std::string& file, const FieldSource& source, const FieldExport& wanted) {
  for (const Field& field : compute_fields(source, {*wanted.field})) {
    const FieldColours colours = colours_of(field, wanted.palette);
    write_field(file, {source.mesh.soup(), field, colours, remark_on(source, *wanted.field)});
  }
}

}  // namespace meshalyzer
