#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The files that paths of a user mean.
struct MeshFiles {
  std::vector<std::string> files;
  /// Folders that could not be listed, or hold no mesh file, in a sentence each.
  std::vector<std::string> troubles;
};

/// Finds the mesh files of paths: a file is itself, of a folder all files in it and in the folders
/// within it whose ending is that of a known format, in order of the bytes of their paths. What
/// begins with a dot is left out, but where it is named itself.
///
/// @param excluded  Patterns of what is left out in folders: see matches_glob().
[[nodiscard]] MeshFiles find_mesh_files(const std::vector<std::string>& paths,
                                        const std::vector<std::string>& excluded);

/// Tells whether a path fits a pattern of the shell. A pattern without a slash is for the last part
/// of the path, one with a slash for all of it; `*` and `?` stand for no slash.
[[nodiscard]] bool matches_glob(std::string_view pattern, std::string_view path);

}  // namespace meshalyzer
