#include "meshalyzer/io/mesh_field.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/field_formats.h"
#include "meshalyzer/io/format_of.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

void require_of(const ColouredValues& column, std::size_t n, const char* message) {
  if (column.values.size() != n || column.colours.size() != n) {
    throw InvalidArgument(message);
  }
}

void require_whole(const MeshField& field) {
  require_of(field.vertices, field.positions.size(),
             "a field that is not of as many vertices as the mesh");
  if (!field.faces.values.empty() || !field.faces.colours.empty()) {
    require_of(field.faces, field.triangles.size(),
               "a field that is not of as many faces as the mesh");
  }
  const auto is_vertex = [&](Index corner) { return corner < field.positions.size(); };
  for (const Triangle& t : field.triangles) {
    if (!std::all_of(t.begin(), t.end(), is_vertex)) {
      throw InvalidArgument("a face has a corner without a vertex");
    }
  }
}

}  // namespace

std::optional<FieldFormat> field_format_of_name(std::string_view name) {
  if (has_ending(name, ".ply")) {
    return FieldFormat::Ply;
  }
  if (has_ending(name, ".obj")) {
    return FieldFormat::Obj;
  }
  if (has_ending(name, ".vtp")) {
    return FieldFormat::Vtp;
  }
  return std::nullopt;
}

std::string print_mesh_field(const MeshField& field, FieldFormat format) {
  require_whole(field);
  switch (format) {
    case FieldFormat::Ply:
      return print_ply_field(field);
    case FieldFormat::Obj:
      return print_obj_field(field);
    case FieldFormat::Vtp:
      return print_vtp_field(field);
  }
  return {};
}

}  // namespace meshalyzer
