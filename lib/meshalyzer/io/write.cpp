#include "meshalyzer/io/write.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/gzip.h"
#include "meshalyzer/io/inria.h"
#include "meshalyzer/io/mesh_format.h"
#include "meshalyzer/io/obj.h"
#include "meshalyzer/io/off.h"
#include "meshalyzer/io/ply.h"
#include "meshalyzer/io/stl.h"
#include "meshalyzer/mesh/require_records.h"

#include <optional>

namespace meshalyzer {
namespace {

std::string print_text(const Soup& soup, Format format) {
  switch (format) {
    case Format::Mesh:
      return print_mesh_format(soup);
    case Format::Inria:
      return print_inria(soup);
    case Format::Obj:
      return print_obj(soup);
    case Format::Off:
      return print_off(soup);
    case Format::Stl:
      return print_ascii_stl(soup);
    case Format::Ply:
      return print_ascii_ply(soup);
  }
  return {};
}

std::string print_binary(const Soup& soup, Format format) {
  switch (format) {
    case Format::Stl:
      return print_binary_stl(soup);
    case Format::Ply:
      return print_binary_ply(soup);
    default:
      throw InvalidArgument("the format '" + std::string(format_name(format)) +
                            "' has no binary encoding");
  }
}

}  // namespace

void write_mesh(const Soup& soup, const std::string& path, Encoding encoding) {
  const std::optional<Format> format = format_of_name(path);
  if (!format) {
    throw InvalidArgument("'" + path + "' has the ending of no known mesh format (" + kMeshEndings +
                          ")");
  }
  const std::string bytes = print_mesh(soup, *format, encoding);
  replace_file(path, is_gzip_name(path) ? pack_gzip(bytes) : bytes);
}

std::string print_mesh(const Soup& soup, Format format, Encoding encoding) {
  require_records(soup);
  return encoding == Encoding::Text ? print_text(soup, format) : print_binary(soup, format);
}

}  // namespace meshalyzer
