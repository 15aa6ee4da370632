#include "output.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/convert/rewrite_as.h"
#include "meshalyzer/io/convert/rewrite_together.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/file_replacement.h"
#include "meshalyzer/io/format_of.h"
#include "meshalyzer/io/gzip.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/io/rewrite/rewrite.h"
#include "meshalyzer/io/stl.h"
#include "meshalyzer/io/write.h"
#include "meshalyzer/repair/edits/edited_mesh_of.h"
#include "targets.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <system_error>
#include <utility>

namespace meshalyzer::fixer {
namespace {

Format output_format(const std::string& path, const Source& source) {
  if (path == source.file.path()) {
    return source.soup.format;
  }
  const Format format = format_of_name(path).value();
  return format == Format::Mesh && source.soup.format == Format::Inria ? Format::Inria : format;
}

/// Returns the result as a new file, with everything that its format can hold.
Output new_file(const EditedMesh& mesh, Format format, const Source& source) {
  Output output;
  Encoding encoding = Encoding::Text;
  if (format == source.soup.format && is_binary(source.file.bytes(), format)) {
    encoding = Encoding::Binary;
    if (format == Format::Stl && !fits_floats(mesh.soup)) {
      encoding = Encoding::Text;
      output.note = "written as text: the floats of binary STL would change coordinates";
    } else if (format == Format::Off) {
      encoding = Encoding::Text;
      output.note = "written as text: binary OFF is only read";
    }
  }
  if (format == source.soup.format && format == Format::Ply) {
    output.note = "written as faces: strips of triangles are only read";
  }
  RewrittenFile file = rewrite_as(mesh, source.file.bytes(), format, encoding);
  output.bytes = std::move(file.bytes);
  output.face_records = std::move(file.file_faces);
  output.loss = {std::move(file.lost), std::move(file.lost_records)};
  return output;
}

/// Returns the bytes of a source, edited.
Output rewritten_output(RewrittenFile file, const Source& source) {
  Output output;
  output.bytes = std::string(source.file.plain().mark()) + file.bytes;
  output.face_records = std::move(file.file_faces);
  output.loss = {std::move(file.lost), std::move(file.lost_records)};
  return output;
}

/// Returns the file of a result before it is packed.
Output make_plain_output(const TrackedMesh& result, bool is_changed, const std::string& path,
                         const Source& source) {
  const Format format = output_format(path, source);
  const bool is_same_format = format == source.soup.format;
  if (is_same_format && !is_changed) {
    return rewritten_output({std::string(source.file.bytes()), {}, {}, {}}, source);
  }
  const EditedMesh mesh = edited_mesh_of(result, source.soup);
  std::optional<RewrittenFile> file =
      is_same_format ? rewrite_mesh(mesh, source.file.bytes()) : std::nullopt;
  return file ? rewritten_output(std::move(*file), source) : new_file(mesh, format, source);
}

/// Counts losses in a part by kind, without records that another part may hold.
std::map<AttributeKind, std::size_t> lost_in_part(const Loss& part) {
  std::map<AttributeKind, std::size_t> counts;
  for (const AttributeCount& count : part.lost) counts[count.kind] += count.count;
  for (const LostRecord& record : part.records) --counts[record.kind];
  return counts;
}

/// Replaces the content of a file, of which a copy is kept; if that fails, the copy is removed.
void replace_kept(const std::string& path, const std::string& bytes) {
  const std::string original = backup_path(path);
  copy_to_new_file(path, original);
  try {
    replace_file(path, bytes);
  } catch (const IoError&) {
    std::error_code ignored;
    std::filesystem::remove(original, ignored);
    throw;
  }
}

}  // namespace

std::string numbered_path(const std::string& path, std::size_t number) {
  const std::filesystem::path whole(path);
  std::filesystem::path stem = whole.stem();
  std::string ending = whole.extension().string();
  if (is_gzip_name(path)) {
    ending.insert(0, stem.extension().string());
    stem = stem.stem();
  }
  const std::string name = stem.string() + '_' + std::to_string(number) + ending;
  return (whole.parent_path() / name).string();
}

Output make_output(const TrackedMesh& result, bool is_changed, const std::string& path,
                   const Source& source) {
  const PlainContent& plain = source.file.plain();
  const bool is_gzipped = path == source.file.path() ? plain.was_gzipped() : is_gzip_name(path);
  const bool is_same = output_format(path, source) == source.soup.format && !is_changed;
  if (is_same && is_gzipped == plain.was_gzipped()) {
    Output output;
    output.bytes = source.file.original();
    return output;
  }
  Output output = make_plain_output(result, is_changed, path, source);
  if (is_gzipped) output.bytes = pack_gzip(output.bytes);
  return output;
}

Output make_joint_output(const TrackedMesh& result, const Soup& all, const std::string& path,
                         std::span<const Source> sources) {
  Format format = format_of_name(path).value();
  const auto all_are = [&](const auto& have) {
    return std::all_of(sources.begin(), sources.end(), have);
  };
  if (format == Format::Mesh &&
      all_are([](const Source& source) { return source.soup.format == Format::Inria; })) {
    format = Format::Inria;
  }
  const bool may_be_binary =
      format == Format::Ply || (format == Format::Stl && fits_floats(result.soup));
  const bool is_binary_file =
      may_be_binary && all_are([&](const Source& source) {
        return source.soup.format == format && is_binary(source.file.bytes(), format);
      });
  std::vector<ReadFile> files;
  for (const Source& source : sources) files.push_back({source.soup, source.file.bytes()});
  RewrittenFile file = rewrite_together(edited_mesh_of(result, all), files, format,
                                        is_binary_file ? Encoding::Binary : Encoding::Text);
  Output output;
  output.bytes = is_gzip_name(path) ? pack_gzip(file.bytes) : std::move(file.bytes);
  output.face_records = std::move(file.file_faces);
  output.loss = {std::move(file.lost), std::move(file.lost_records)};
  return output;
}

std::vector<AttributeCount> lost_by_all(const std::vector<Loss>& parts, const Source& source) {
  std::map<AttributeKind, std::size_t> counts;
  std::map<std::pair<AttributeKind, std::size_t>, std::size_t> n_losers;
  for (const Loss& part : parts) {
    for (const auto& [kind, count] : lost_in_part(part)) {
      // A polygon belongs to one part; attributes that the format cannot hold are lost in each.
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

Soup write_output(const Output& output, const std::string& path, Options::Backup backup) {
  // A file that cannot be read back must not replace an older one.
  Soup soup = parse_mesh(output.bytes, path);
  if (backup == Options::Backup::Original) {
    replace_kept(path, output.bytes);
  } else {
    replace_file(path, output.bytes);
  }
  std::error_code ignored;
  // A pipe gives nothing back.
  if (!std::filesystem::is_regular_file(path, ignored)) return soup;
  const FileContent written(path);
  if (written.bytes() != output.bytes) soup = parse_mesh(written.bytes(), path);
  return soup;
}

std::string name_of_stdout(Format format) {
  return "standard output." +
         std::string(format_name(format == Format::Inria ? Format::Mesh : format));
}

Soup write_to_stdout(const Output& output, const std::string& name, std::ostream& out) {
  Soup soup = parse_mesh(output.bytes, name);
  out << output.bytes << std::flush;
  if (!out) throw IoError("standard output", {}, "cannot be written");
  return soup;
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
