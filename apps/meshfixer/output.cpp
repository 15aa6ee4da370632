#include "output.h"

#include "meshalyzer/io/file.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/io/stl.h"
#include "meshalyzer/io/write.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace meshalyzer::fixer {
namespace {

Format output_format(const std::string& path, const Source& source) {
  const Format format = format_of_name(path).value();
  return format == Format::Mesh && source.format == Format::Inria ? Format::Inria : format;
}

bool is_binary(const Source& source) {
  if (source.format == Format::Stl) {
    return is_binary_stl(source.bytes) || source.bytes.find('\0') != std::string_view::npos;
  }
  return source.format == Format::Ply &&
         source.bytes.substr(0, 200).find("format binary") != std::string_view::npos;
}

/// Whether 32-bit floats hold all coordinates.
bool fits_floats(const Soup& soup) {
  return std::all_of(soup.positions.begin(), soup.positions.end(), [](const Vec3& p) {
    return std::all_of(p.begin(), p.end(),
                       [](double x) { return static_cast<double>(static_cast<float>(x)) == x; });
  });
}

}  // namespace

std::string numbered_path(const std::string& path, std::size_t number) {
  const std::filesystem::path whole(path);
  std::string name = whole.stem().string();
  name += '_';
  name += std::to_string(number);
  name += whole.extension().string();
  return (whole.parent_path() / name).string();
}

bool has_content(const Soup& soup, const std::string& path) {
  const bool holds_faces_only = format_of_name(path) == Format::Stl;
  return soup.n_faces() != 0 || (soup.n_vertices() != 0 && !holds_faces_only);
}

std::vector<Index> vertex_records(const Soup& soup, const Soup& disk) {
  if (disk.format != Format::Stl) return {};
  std::vector<Index> records(soup.n_vertices(), kNoIndex);
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) records[soup.triangles[f][k]] = disk.triangles[f][k];
  }
  return records;
}

bool keeps_format(const std::string& path, const Source& source) {
  return output_format(path, source) == source.format;
}

Written write_result(const Soup& soup, const std::string& path, const Source& source) {
  Written written;
  Encoding encoding = Encoding::Text;
  if (keeps_format(path, source) && is_binary(source)) {
    encoding = Encoding::Binary;
    if (source.format == Format::Stl && !fits_floats(soup)) {
      encoding = Encoding::Text;
      written.note = "written as text: the floats of binary STL would change coordinates";
    }
  }
  const std::string bytes = print_mesh(soup, output_format(path, source), encoding);
  // What cannot be read must not take the place of an older file.
  static_cast<void>(parse_mesh(bytes, path));
  replace_file(path, bytes);
  written.soup = read_mesh(path);
  return written;
}

Written write_unchanged(const std::string& path, const Source& source) {
  replace_file(path, source.bytes);
  return {read_mesh(path), ""};
}

}  // namespace meshalyzer::fixer
