#include "output.h"

#include "meshalyzer/io/convert/rewrite_as.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/io/rewrite/rewrite.h"
#include "meshalyzer/io/write.h"
#include "meshalyzer/repair/edits/edited_mesh_of.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

namespace meshalyzer::fixer {
namespace {

Format output_format(const std::string& path, const Source& source) {
  const Format format = format_of_name(path).value();
  return format == Format::Mesh && source.soup.format == Format::Inria ? Format::Inria : format;
}

/// Whether 32-bit floats hold all coordinates.
bool fits_floats(const Soup& soup) {
  return std::all_of(soup.positions.begin(), soup.positions.end(), [](const Vec3& p) {
    return std::all_of(p.begin(), p.end(),
                       [](double x) { return static_cast<double>(static_cast<float>(x)) == x; });
  });
}

/// The result as a new file, with what its format can hold.
Output new_file(const EditedMesh& mesh, Format format, const Source& source) {
  Output output;
  Encoding encoding = Encoding::Text;
  if (format == source.soup.format && is_binary(source.bytes, format)) {
    encoding = Encoding::Binary;
    if (format == Format::Stl && !fits_floats(mesh.soup)) {
      encoding = Encoding::Text;
      output.note = "written as text: the floats of binary STL would change coordinates";
    }
  }
  RewrittenFile file = rewrite_as(mesh, source.bytes, format, encoding);
  output.bytes = std::move(file.bytes);
  output.face_records = std::move(file.file_faces);
  output.loss = {std::move(file.lost), std::move(file.lost_records)};
  return output;
}

/// By kind: how many are lost in a part, but for records that another part may have.
std::map<AttributeKind, std::size_t> lost_in_part(const Loss& part) {
  std::map<AttributeKind, std::size_t> counts;
  for (const AttributeCount& count : part.lost) counts[count.kind] += count.count;
  for (const LostRecord& record : part.records) --counts[record.kind];
  return counts;
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

Output make_output(const TrackedMesh& result, bool is_changed, const std::string& path,
                   const Source& source) {
  const Format format = output_format(path, source);
  if (!is_changed && format == source.soup.format) {
    Output output;
    output.bytes = source.bytes;
    return output;
  }
  const EditedMesh mesh = edited_mesh_of(result, source.soup);
  if (format != source.soup.format) {
    return new_file(mesh, format, source);
  }
  std::optional<RewrittenFile> file = rewrite_mesh(mesh, source.bytes);
  if (!file) {
    return new_file(mesh, format, source);
  }
  return {std::move(file->bytes),
          std::move(file->file_faces),
          {std::move(file->lost), std::move(file->lost_records)},
          ""};
}

std::vector<AttributeCount> lost_by_all(const std::vector<Loss>& parts, const Source& source) {
  std::map<AttributeKind, std::size_t> counts;
  std::map<std::pair<AttributeKind, std::size_t>, std::size_t> n_losers;
  for (const Loss& part : parts) {
    for (const auto& [kind, count] : lost_in_part(part)) {
      // A polygon is in one part; what the format cannot hold is lost in each.
      std::size_t& all = counts[kind];
      all = kind == AttributeKind::Polygons ? std::min(all + count, source.soup.n_polygons)
                                            : std::max(all, count);
    }
    for (const LostRecord& record : part.records) ++n_losers[{record.kind, record.offset}];
  }
  std::vector<AttributeCount> lost;
  for (const auto& [kind, count] : counts) lost.push_back({kind, count});
  for (const auto& [record, n] : n_losers) {
    lost.push_back({record.first, n == parts.size() ? 1U : 0U});
  }
  return summed(std::move(lost));
}

Soup write_output(const Output& output, const std::string& path) {
  // What cannot be read must not take the place of an older file.
  static_cast<void>(parse_mesh(output.bytes, path));
  replace_file(path, output.bytes);
  return read_mesh(path);
}

bool has_content(const Soup& soup, const std::string& path) {
  const bool holds_faces_only = format_of_name(path) == Format::Stl;
  return soup.n_faces() != 0 || (soup.n_vertices() != 0 && !holds_faces_only);
}

std::vector<Index> vertex_records(const Soup& soup, const Soup& disk,
                                  const std::vector<Index>& face_records) {
  if (disk.format != Format::Stl) return {};
  std::vector<Index> records(soup.n_vertices(), kNoIndex);
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    const std::size_t on_disk = face_records.empty() ? f : face_records[f];
    for (std::size_t k = 0; k < 3; ++k) records[soup.triangles[f][k]] = disk.triangles[on_disk][k];
  }
  return records;
}

}  // namespace meshalyzer::fixer
