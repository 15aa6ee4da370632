#pragma once

#include <string>
#include <vector>

namespace meshalyzer {

/// The mesh files of a folder.
struct MeshFolder {
  /// The files with the ending of a known format, whatever its case, in order of the bytes of their
  /// names; folders within the folder do not count.
  std::vector<std::string> files;
  /// The reason why the folder could not be listed, or that it held no mesh; mostly empty.
  std::string error;
};

/// Tells whether a path is a folder.
[[nodiscard]] bool is_folder(const std::string& path);

[[nodiscard]] MeshFolder list_mesh_folder(const std::string& folder);

}  // namespace meshalyzer
