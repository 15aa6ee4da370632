#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The mesh files that the paths of a user stand for.
struct MeshFiles {
  std::vector<std::string> files;
  /// Folders that could not be listed, subfolders too, or that hold no mesh file, in a sentence
  /// each.
  std::vector<std::string> errors;
  /// The number of mesh files in folders of which all mesh files are excluded.
  std::size_t n_excluded = 0;
};

/// Finds the mesh files of paths. A file stands for itself, a folder for all files in it and its
/// subfolders with the ending of a known format, in byte order of their paths. Names that begin
/// with a dot are skipped, unless the user names them.
///
/// @param excluded  Patterns of paths to skip in folders: see matches_glob().
[[nodiscard]] MeshFiles find_mesh_files(const std::vector<std::string>& paths,
                                        const std::vector<std::string>& excluded);

/// Tells whether a path matches a shell pattern. A pattern without a slash is compared with the
/// last part of the path, one with a slash with all of it; `*` and `?` do not match a slash. A
/// slash at the end of a pattern, as of a folder, counts for nothing.
[[nodiscard]] bool matches_glob(std::string_view pattern, std::string_view path);

}  // namespace meshalyzer
