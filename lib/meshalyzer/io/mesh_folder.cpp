#include "meshalyzer/io/mesh_folder.h"

#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/io/format_of.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace meshalyzer {
namespace {

namespace fs = std::filesystem;

void add_entry(const fs::directory_entry& entry, MeshFolder& folder) {
  if (entry.path().filename().string().front() == '.') return;
  std::error_code ignored;  // an entry that cannot be examined is reported when it is read
  const fs::file_status status = entry.status(ignored);
  const std::string path = entry.path().string();
  if (fs::is_directory(status)) {
    if (!entry.is_symlink(ignored)) folder.folders.push_back(path);
  } else if (format_of_name(path) && !fs::is_other(status)) {
    folder.files.push_back(path);
  }
}

}  // namespace

MeshFolder list_mesh_folder(const std::string& folder) {
  MeshFolder listed;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    add_entry(*entry, listed);
  }
  if (error) {
    listed.error = without_controls(folder) + ": cannot list the folder: " + error.message();
  }
  std::sort(listed.files.begin(), listed.files.end());
  std::sort(listed.folders.begin(), listed.folders.end());
  return listed;
}

std::string no_mesh_in(const std::string& folder) {
  return without_controls(folder) + ": no mesh file in the folder (" + kMeshEndings + ")";
}

}  // namespace meshalyzer
