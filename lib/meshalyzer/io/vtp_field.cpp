#include "meshalyzer/base/base64.h"
#include "meshalyzer/base/bytes.h"
#include "meshalyzer/io/field_formats.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace meshalyzer {
namespace {

// The format is described in "VTK XML Formats" in the VTK documentation: the content of an array
// is, in base64, the number of its bytes, in the type that header_type names, followed by the
// bytes.

/// The attributes in the head of an array.
struct ArrayHead {
  std::string_view type;
  std::string_view name;
  std::size_t n_components = 1;
};

void print_array(std::string& text, const ArrayHead& head, const std::string& bytes) {
  text.append("<DataArray type=\"").append(head.type).append("\" Name=\"").append(head.name);
  text.append("\" NumberOfComponents=\"").append(std::to_string(head.n_components));
  text += "\" format=\"binary\">\n";
  std::string content;
  content.reserve(sizeof(std::uint64_t) + bytes.size());
  append_little_endian(content, std::uint64_t{bytes.size()});
  content += bytes;
  append_base64(text, content);
  text += "\n</DataArray>\n";
}

void print_reals(std::string& text, std::string_view name, std::span<const double> values) {
  std::string bytes;
  bytes.reserve(sizeof(double) * values.size());
  for (const double value : values) {
    append_little_endian(bytes, value);
  }
  print_array(text, {"Float64", name}, bytes);
}

void print_colours(std::string& text, std::span<const Colour> colours) {
  std::string bytes;
  bytes.reserve(3 * colours.size());
  for (const Colour& colour : colours) {
    append_little_endian(bytes, colour.red);
    append_little_endian(bytes, colour.green);
    append_little_endian(bytes, colour.blue);
  }
  print_array(text, {"UInt8", "RGB", 3}, bytes);
}

/// Prints the contents of the element PointData or CellData.
void print_values(std::string& text, std::string_view name, const ColouredValues& column) {
  print_reals(text, name, column.values);
  print_colours(text, column.colours);
}

void print_points(std::string& text, std::span<const Vec3> positions) {
  std::string bytes;
  bytes.reserve(3 * sizeof(double) * positions.size());
  for (const Vec3& position : positions) {
    for (const double coordinate : position) {
      append_little_endian(bytes, coordinate);
    }
  }
  text += "<Points>\n";
  print_array(text, {"Float64", "Points", 3}, bytes);
  text += "</Points>\n";
}

void print_polygons(std::string& text, std::span<const Triangle> triangles) {
  std::string corners;
  std::string ends;
  corners.reserve(3 * sizeof(std::int64_t) * triangles.size());
  ends.reserve(sizeof(std::int64_t) * triangles.size());
  std::int64_t end = 0;
  for (const Triangle& t : triangles) {
    for (const Index corner : t) {
      append_little_endian(corners, std::int64_t{corner});
    }
    end += 3;
    append_little_endian(ends, end);
  }
  text += "<Polys>\n";
  print_array(text, {"Int64", "connectivity"}, corners);
  print_array(text, {"Int64", "offsets"}, ends);
  text += "</Polys>\n";
}

}  // namespace

std::string print_vtp_field(const MeshField& field) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n";
  text.append("<Piece NumberOfPoints=\"").append(std::to_string(field.positions.size()));
  text += "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"";
  text.append(std::to_string(field.triangles.size())).append("\">\n");
  text.append("<PointData Scalars=\"").append(field.name).append("\">\n");
  print_values(text, field.name, field.vertices);
  text += "</PointData>\n";
  if (!field.faces.values.empty()) {
    text.append("<CellData Scalars=\"").append(field.name).append("\">\n");
    print_values(text, field.name, field.faces);
    text += "</CellData>\n";
  }
  print_points(text, field.positions);
  print_polygons(text, field.triangles);
  return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace meshalyzer
