#pragma once

#include "input_file.h"
#include "meshalyzer/io/attributes.h"
#include "meshalyzer/io/rewrite/rewritten_file.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer::fixer {

/// The file that was read.
struct Source {
  const InputFile& file;
  /// What it says.
  const Soup& soup;
};

/// What of a source is not in a file.
struct Loss {
  std::vector<AttributeCount> lost;
  /// Tells which of that are records whose elements are not in it.
  std::vector<LostRecord> records;
};

/// What is to be written.
struct Output {
  std::string bytes;
  /// The record in the file of each face of the result; empty where they are the same.
  std::vector<Index> face_records;
  Loss loss;
  /// A note for the user; mostly empty.
  std::string note;
};

/// Returns the path of one of several outputs: "a.mesh" becomes "a_2.mesh", "a.obj.gz"
/// "a_2.obj.gz".
[[nodiscard]] std::string numbered_path(const std::string& path, std::size_t number);

/// Makes the file of a result in the format of a path's ending (INRIA's .mesh where the source was
/// one), gzipped where it ends in .gz; what takes the place of the source stays in its format. In
/// the source's format what was not changed stays as it is; where nothing was, that is all.
///
/// @param is_changed  Whether anything was.
[[nodiscard]] Output make_output(const TrackedMesh& result, bool is_changed,
                                 const std::string& path, const Source& source);

/// Makes the file of a mesh that was made of those of several files, in the format of a path's
/// ending (INRIA's .mesh where all sources are), with what this format can say of all of them.
///
/// @param all  The records of all sources, one behind the other.
[[nodiscard]] Output make_joint_output(const TrackedMesh& result, const Soup& all,
                                       const std::string& path, std::span<const Source> sources);

/// What of a source is in none of the files that hold its parts.
[[nodiscard]] std::vector<AttributeCount> lost_by_all(const std::vector<Loss>& parts,
                                                      const Source& source);

/// Writes a file and reads it back. The old file, if any, stays until the new one is complete, and
/// what cannot be read does not take its place.
///
/// @throws IoError  where it cannot be written or read back.
[[nodiscard]] Soup write_output(const Output& output, const std::string& path);

/// Tells whether there is anything to write: the ending of a path may be that of a format that
/// holds faces only (STL).
[[nodiscard]] bool has_content(const Soup& soup, const std::string& path);

/// Returns the record on disk of each vertex that was written, kNoIndex where it has none; empty
/// where they are the same. Only STL, which names no vertices, numbers them anew.
///
/// @param face_records  As Output::face_records.
[[nodiscard]] std::vector<Index> vertex_records(const Soup& soup, const Soup& disk,
                                                const std::vector<Index>& face_records);

}  // namespace meshalyzer::fixer
