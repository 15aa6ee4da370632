#pragma once

#include <string>
#include <vector>

namespace meshalyzer {

/// The mesh files and the folders in a folder. Those whose names begin with a dot are left out, as
/// shells do in `FOLDER/*`: they are not for people (`._cube.stl`, which macOS puts beside
/// `cube.stl`, is no mesh).
struct MeshFolder {
  /// The files with the ending of a known format, whatever its case, in order of the bytes of their
  /// names.
  std::vector<std::string> files;
  /// The folders, without links to folders, in the same order.
  std::vector<std::string> folders;
  /// The reason why the folder could not be listed; mostly empty.
  std::string error;
};

[[nodiscard]] MeshFolder list_mesh_folder(const std::string& folder);

/// Returns the error that a folder holds no mesh file.
[[nodiscard]] std::string no_mesh_in(const std::string& folder);

}  // namespace meshalyzer
