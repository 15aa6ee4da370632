#include "meshalyzer/io/read.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/inria.h"
#include "meshalyzer/io/mesh_format.h"
#include "meshalyzer/io/obj.h"
#include "meshalyzer/io/off.h"
#include "meshalyzer/io/ply.h"
#include "meshalyzer/io/stl.h"

#include <optional>

namespace meshalyzer {
namespace {

Format decide_format(std::string_view content, const std::string& name) {
  const std::optional<Format> by_name = format_of_name(name);
  if (by_name) {
    return *by_name == Format::Mesh && is_inria(content) ? Format::Inria : *by_name;
  }
  const std::optional<Format> by_content = format_of_content(content);
  if (!by_content) {
    throw IoError(name, {.line = 1},
                  "neither the name nor the content is that of a known mesh format");
  }
  return *by_content;
}

Soup parse_as(Format format, std::string_view content, const std::string& name) {
  switch (format) {
    case Format::Mesh:
      return parse_mesh_format(content, name);
    case Format::Inria:
      return parse_inria(content, name);
    case Format::Obj:
      return parse_obj(content, name);
    case Format::Off:
      return parse_off(content, name);
    case Format::Stl:
      return parse_stl(content, name);
    case Format::Ply:
      return parse_ply(content, name);
  }
  return {};
}

}  // namespace

Soup read_mesh(const std::string& path) {
  const FileContent content(path);
  return parse_mesh(content.bytes(), path);
}

Soup parse_mesh(std::string_view content, const std::string& name) {
  if (content.empty()) {
    throw IoError(name, {.line = 1}, "the file is empty");
  }
  Soup soup = parse_as(decide_format(content, name), content, name);
  if (soup.positions.empty() && soup.triangles.empty()) {
    throw IoError(name, {.line = 1}, "no mesh in it: neither a vertex nor a face");
  }
  return soup;
}

}  // namespace meshalyzer
