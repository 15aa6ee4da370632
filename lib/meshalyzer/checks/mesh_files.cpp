#include "meshalyzer/checks/mesh_files.h"

#include "meshalyzer/io/mesh_folder.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fnmatch.h>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

namespace fs = std::filesystem;

/// Finds the mesh files of a folder and of the folders within it.
class FolderSearch {
 public:
  FolderSearch(std::string folder, std::vector<std::string> excluded)
      : folder_(std::move(folder)), excluded_(std::move(excluded)) {
    search(folder_);
    std::sort(files_.begin(), files_.end());
    if (!files_.empty() || !errors_.empty()) return;
    if (!excluded_.empty()) n_excluded_ = FolderSearch(folder_, {}).files_.size();
    if (n_excluded_ == 0) errors_.push_back(no_mesh_in(folder_));
  }

  void add_to(MeshFiles& found) const {
    found.files.insert(found.files.end(), files_.begin(), files_.end());
    found.errors.insert(found.errors.end(), errors_.begin(), errors_.end());
    found.n_excluded += n_excluded_;
  }

 private:
  void search(const std::string& folder) {
    const MeshFolder listed = list_mesh_folder(folder);
    if (!listed.error.empty()) errors_.push_back(listed.error);
    for (const std::string& file : listed.files) {
      if (!is_left_out(file)) files_.push_back(name_of(file));
    }
    for (const std::string& inner : listed.folders) {
      if (!is_left_out(inner)) search(name_of(inner));
    }
  }

  [[nodiscard]] bool is_left_out(const fs::path& path) const {
    const fs::path within = path.lexically_relative(folder_);
    const std::string whole = (fs::path(folder_) / within).string();
    return std::any_of(excluded_.begin(), excluded_.end(), [&](const std::string& pattern) {
      return matches_glob(pattern, within.string()) || matches_glob(pattern, whole);
    });
  }

  /// Files and folders in "." are named as a person would name them.
  [[nodiscard]] std::string name_of(const std::string& path) const {
    return folder_ == "." || folder_ == "./" ? fs::path(path).lexically_relative(folder_).string()
                                             : path;
  }

  std::string folder_;
  std::vector<std::string> excluded_;
  std::vector<std::string> files_;
  std::vector<std::string> errors_;
  std::size_t n_excluded_ = 0;
};

}  // namespace

MeshFiles find_mesh_files(const std::vector<std::string>& paths,
                          const std::vector<std::string>& excluded) {
  MeshFiles found;
  for (const std::string& path : paths) {
    std::error_code ignored;  // a path that is no folder is reported when it is read
    if (fs::is_directory(path, ignored)) {
      FolderSearch(path, excluded).add_to(found);
    } else {
      found.files.push_back(path);
    }
  }
  return found;
}

bool matches_glob(std::string_view pattern, std::string_view path) {
  if (pattern.ends_with('/')) pattern.remove_suffix(1);
  const bool is_for_name = pattern.find('/') == std::string_view::npos;
  const std::string subject(is_for_name ? path.substr(path.find_last_of('/') + 1) : path);
  return ::fnmatch(std::string(pattern).c_str(), subject.c_str(), FNM_PATHNAME) == 0;
}

}  // namespace meshalyzer
