#include "mesh_folder.h"

#include "meshalyzer/io/format_of.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace meshalyzer {
namespace fs = std::filesystem;

bool is_folder(const std::string& path) {
  std::error_code ignored;  // a path that is no folder is reported when it is read
  return fs::is_directory(path, ignored);
}

MeshFolder list_mesh_folder(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;  // an entry that cannot be examined is reported when it is read
    const fs::file_status status = entry->status(ignored);
    if (format_of_name(entry->path().filename().string()) && !fs::is_directory(status) &&
        !fs::is_other(status)) {
      names.push_back(entry->path().filename().string());
    }
  }
  MeshFolder result;
  if (error) {
    result.error = folder + ": cannot list the folder: " + error.message();
  } else if (names.empty()) {
    result.error = folder + ": no mesh file in the folder (" + kMeshEndings + ")";
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    result.files.push_back((fs::path(folder) / name).string());
  }
  return result;
}

}  // namespace meshalyzer
