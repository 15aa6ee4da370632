#include "meshalyzer/io/read.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/inria.h"
#include "meshalyzer/io/mesh_format.h"
#include "meshalyzer/io/obj.h"
#include "meshalyzer/io/off.h"
#include "meshalyzer/io/plain_content.h"
#include "meshalyzer/io/ply.h"
#include "meshalyzer/io/stl.h"

#include <optional>

namespace meshalyzer {
namespace {

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

/// Tells whether a content begins with the byte order mark of UTF-16 and is not a binary mesh file.
bool is_utf16(std::string_view content) {
  const std::string_view mark = content.substr(0, 2);
  return (mark == "\xff\xfe" || mark == "\xfe\xff") && !format_of_content(content);
}

}  // namespace

Soup read_mesh(const std::string& path) {
  const FileContent content(path);
  return parse_mesh(content.bytes(), path);
}

Soup parse_mesh(std::string_view content, const std::string& name) {
  const PlainContent plain(content, name);
  if (plain.bytes().empty()) {
    throw IoError(name, {.line = 1}, "the file is empty");
  }
  if (is_utf16(plain.bytes())) {
    throw IoError(name, {.line = 1}, "is text in UTF-16: only UTF-8 is read");
  }
  const std::optional<Format> format = format_of(plain.bytes(), name);
  if (!format) {
    throw IoError(name, {.line = 1},
                  std::string("neither the name nor the content is that of a known mesh format (") +
                      kMeshEndings + ")");
  }
  Soup soup = parse_as(*format, plain.bytes(), name);
  if (soup.positions.empty() && soup.triangles.empty()) {
    throw IoError(name, {.line = 1}, "no mesh in it: neither a vertex nor a face");
  }
  return soup;
}

}  // namespace meshalyzer
