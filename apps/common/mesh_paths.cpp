#include "mesh_paths.h"

#include "meshalyzer/io/mesh_folder.h"

#include <filesystem>
#include <system_error>

namespace meshalyzer {

bool is_folder(const std::string& path) {
  std::error_code ignored;  // a path that is no folder is reported when it is read
  return std::filesystem::is_directory(path, ignored);
}

MeshPaths find_meshes(const std::vector<std::string>& paths) {
  MeshPaths found;
  for (const std::string& path : paths) {
    if (!is_folder(path)) {
      found.files.push_back(path);
      continue;
    }
    found.has_folder = true;
    const MeshFolder folder = list_mesh_folder(path);
    found.files.insert(found.files.end(), folder.files.begin(), folder.files.end());
    if (!folder.error.empty()) {
      found.errors.push_back(folder.error);
    } else if (folder.files.empty()) {
      found.errors.push_back(no_mesh_in(path));
    }
  }
  return found;
}

}  // namespace meshalyzer
