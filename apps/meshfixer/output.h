#pragma once

#include "input_file.h"
#include "meshalyzer/io/attributes.h"
#include "meshalyzer/io/rewrite/rewritten_file.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"
#include "options.h"

#include <cstddef>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer::fixer {

/// The file that was read.
struct Source {
  const InputFile& file;
  /// The records of the file.
  const Soup& soup;
};

/// The losses of a file: parts of the source that it does not hold.
struct Loss {
  std::vector<AttributeCount> lost;
  /// The losses that are records whose elements are not in it.
  std::vector<LostRecord> records;
};

/// A file to be written.
struct Output {
  std::string bytes;
  /// The record in the file of each face of the result; empty if they are the same.
  std::vector<Index> face_records;
  Loss loss;
  /// A note for the user; mostly empty.
  std::string note;
};

/// Returns the path of one of several outputs: "a.mesh" becomes "a_2.mesh", "a.obj.gz"
/// "a_2.obj.gz".
[[nodiscard]] std::string numbered_path(const std::string& path, std::size_t number);

/// Makes the file of a result in the format of a path's ending (INRIA's .mesh if the source was
/// one), gzipped if it ends in .gz; a file that replaces the source keeps its format. In the
/// source's format unchanged records keep their bytes; if nothing was changed, so does the whole
/// file.
///
/// @param is_changed  True if anything was changed.
[[nodiscard]] Output make_output(const TrackedMesh& result, bool is_changed,
                                 const std::string& path, const Source& source);

/// Makes the file of a mesh that combines those of several files, in the format of a path's ending
/// (INRIA's .mesh if all sources are), with everything of theirs that this format can hold.
///
/// @param all  The records of all sources, concatenated.
[[nodiscard]] Output make_joint_output(const TrackedMesh& result, const Soup& all,
                                       const std::string& path, std::span<const Source> sources);

/// Counts the losses that none of the files of its parts holds.
[[nodiscard]] std::vector<AttributeCount> lost_by_all(const std::vector<Loss>& parts,
                                                      const Source& source);

/// Writes a file and reads it back, unless it is a pipe or a device. An old file stays until the
/// new one is complete; a file that cannot be read back does not replace it.
///
/// @param backup  Whether the old file is kept as backup_path(); if it stays, there is no backup.
/// @throws IoError  if it cannot be written or read back.
[[nodiscard]] Soup write_output(const Output& output, const std::string& path,
                                Options::Backup backup = Options::Backup::None);

/// Returns the name of standard output in messages, whose ending tells the format.
[[nodiscard]] std::string name_of_stdout(Format format);

/// Writes a file to standard output.
///
/// @param name  The result of name_of_stdout(), with `.gz` if the file is gzipped.
/// @return      The mesh, read back from the bytes.
/// @throws IoError  if it cannot be written or read back.
[[nodiscard]] Soup write_to_stdout(const Output& output, const std::string& name,
                                   std::ostream& out);

/// Tells whether there is anything to write: a format may hold only faces (STL).
[[nodiscard]] bool has_content(const Soup& soup, const std::string& path);

/// Returns the record on disk of each written vertex, kNoIndex if it has none; empty if they are
/// the same. Only STL, which names no vertices, renumbers them.
///
/// @param face_records  As Output::face_records.
[[nodiscard]] std::vector<Index> vertex_records(const Soup& soup, const Soup& disk,
                                                const std::vector<Index>& face_records);

}  // namespace meshalyzer::fixer
