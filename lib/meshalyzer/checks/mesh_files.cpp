#include "meshalyzer/checks/mesh_files.h"

#include "meshalyzer/io/format_of.h"

#include <algorithm>
#include <filesystem>
#include <fnmatch.h>
#include <iterator>
#include <system_error>
#include <utility>

namespace meshalyzer {
namespace {

namespace fs = std::filesystem;

/// Finds the mesh files of one folder.
class FolderSearch {
 public:
  FolderSearch(const fs::path& folder, const std::vector<std::string>& excluded)
      : folder_(folder), excluded_(excluded) {}

  /// @param error  Says why the folder could not be listed.
  [[nodiscard]] std::vector<std::string> run(std::error_code& error) {
    constexpr auto kOptions = fs::directory_options::skip_permission_denied;
    fs::recursive_directory_iterator entry(folder_, kOptions, error);
    while (!error && entry != fs::recursive_directory_iterator()) {
      std::error_code ignored;  // an entry that cannot be examined is reported when it is read
      const fs::file_status status = entry->status(ignored);
      if (is_left_out(entry->path())) {
        entry.disable_recursion_pending();
      } else if (format_of_name(entry->path().string()) && !fs::is_directory(status) &&
                 !fs::is_other(status)) {
        files_.push_back(name_of(entry->path()));
      }
      entry.increment(error);
    }
    std::sort(files_.begin(), files_.end());
    return std::move(files_);
  }

 private:
  [[nodiscard]] bool is_left_out(const fs::path& path) const {
    const std::string name = path.filename().string();
    const std::string within = path.lexically_relative(folder_).string();
    return name.front() == '.' ||
           std::any_of(excluded_.begin(), excluded_.end(), [&](const std::string& pattern) {
             return matches_glob(pattern, within) || matches_glob(pattern, path.string());
           });
  }

  /// Files in "." are named as a person would name them.
  [[nodiscard]] std::string name_of(const fs::path& path) const {
    return folder_ == "." || folder_ == "./" ? path.lexically_relative(folder_).string()
                                             : path.string();
  }

  fs::path folder_;
  const std::vector<std::string>& excluded_;
  std::vector<std::string> files_;
};

}  // namespace

MeshFiles find_mesh_files(const std::vector<std::string>& paths,
                          const std::vector<std::string>& excluded) {
  MeshFiles found;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      found.files.push_back(path);
      continue;
    }
    std::vector<std::string> files = FolderSearch(path, excluded).run(error);
    if (error) {
      found.errors.push_back(path + ": cannot list the folder: " + error.message());
    } else if (files.empty()) {
      found.errors.push_back(path + ": no mesh file in the folder (" + kMeshEndings + ")");
    }
    found.files.insert(found.files.end(), std::make_move_iterator(files.begin()),
                       std::make_move_iterator(files.end()));
  }
  return found;
}

bool matches_glob(std::string_view pattern, std::string_view path) {
  const bool is_for_name = pattern.find('/') == std::string_view::npos;
  const std::string subject(is_for_name ? path.substr(path.find_last_of('/') + 1) : path);
  return ::fnmatch(std::string(pattern).c_str(), subject.c_str(), FNM_PATHNAME) == 0;
}

}  // namespace meshalyzer
