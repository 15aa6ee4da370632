#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/report/repair_report.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer::fixer {

/// The file that was read.
struct Source {
  std::string_view bytes;
  Format format = Format::Mesh;
};

/// The file that was written.
struct Written {
  /// The mesh on disk, read back.
  Soup soup;
  /// A note for the user; mostly empty.
  std::string note;
};

/// The path of one of several outputs: "a.mesh" becomes "a_2.mesh".
[[nodiscard]] std::string numbered_path(const std::string& path, std::size_t number);

/// Writes a mesh in the format of the path's ending (INRIA's .mesh where the source was one), in
/// binary where the source was of the same format in binary and loses nothing by it, and reads it
/// back. The old file, if any, stays until the new one is complete.
///
/// @throws IoError  where it cannot be written or read back.
[[nodiscard]] Written write_result(const Soup& soup, const std::string& path, const Source& source);

/// Writes the source's own bytes: for a mesh in which nothing was changed.
[[nodiscard]] Written write_unchanged(const std::string& path, const Source& source);

/// Whether there is anything to write: the ending of a path may be that of a format that holds
/// faces only (STL).
[[nodiscard]] bool has_content(const Soup& soup, const std::string& path);

/// Returns the record on disk of each vertex that was written, kNoIndex where it has none; empty
/// where they are the same. Only STL, which names no vertices, numbers them anew.
[[nodiscard]] std::vector<Index> vertex_records(const Soup& soup, const Soup& disk);

/// Whether the ending of a path asks for the format that the source has.
[[nodiscard]] bool keeps_format(const std::string& path, const Source& source);

}  // namespace meshalyzer::fixer
