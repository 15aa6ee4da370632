#include "picture_paths.h"

#include "file_ending.h"
#include "file_identity.h"
#include "mesh_paths.h"
#include "usage_error.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace meshalyzer {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> file_names_of(const std::vector<std::string>& paths,
                                       const std::string& ending) {
  std::vector<std::string> names;
  std::set<std::string> distinct;
  for (const std::string& path : paths) {
    names.push_back(fs::path(path).filename().replace_extension(ending).string());
    distinct.insert(names.back());
  }
  if (distinct.size() != paths.size()) {
    for (std::size_t i = 0; i < paths.size(); ++i) {
      names[i] = std::to_string(i + 1);
      names[i] += '_';
      names[i] += fs::path(paths[i]).filename().string();
      names[i] += ending;
    }
  }
  return names;
}

/// Returns the paths of one file for each mesh in a folder.
std::vector<std::string> files_in(const fs::path& folder, const std::vector<std::string>& names) {
  std::vector<std::string> files;
  std::transform(names.begin(), names.end(), std::back_inserter(files),
                 [&](const std::string& name) { return (folder / name).string(); });
  return files;
}

fs::path without_ending(const std::string& file) {
  return fs::path(file).replace_extension();
}

void name_pages(const std::string& file, const Inputs& inputs, PicturePaths& paths) {
  const std::string ending = require_ending(file, "--html", {".html", ".htm"});
  if (inputs.files.size() == 1 && !inputs.is_set) {
    paths.pages = {file};
    return;
  }
  fs::path folder = without_ending(file);
  folder += "_pages";
  const std::vector<std::string> names = file_names_of(inputs.files, ending);
  paths.folders.push_back(folder.string());
  paths.pages = files_in(folder, names);
  paths.links = files_in(folder.filename(), names);
  paths.index = file;
}

void name_fields(const std::string& file, const Inputs& inputs, PicturePaths& paths) {
  const std::string ending = require_ending(file, "--export", {".ply", ".obj", ".vtp"});
  if (inputs.files.size() == 1 && !inputs.is_set) {
    paths.fields = {file};
    return;
  }
  const fs::path folder = without_ending(file);
  paths.folders.push_back(folder.string());
  paths.fields = files_in(folder, file_names_of(inputs.files, ending));
}

/// Rejects folders that are inputs too: the next run would take the files written there for meshes.
void refuse_looked_at(const std::vector<std::string>& folders, const Options& options) {
  for (const std::string& folder : folders) {
    for (const std::string& path : options.paths) {
      if (is_folder(path) && is_same_file(folder, path)) {
        throw UsageError("meshes would be written into " + folder +
                         ", among those that are looked at: name another folder");
      }
    }
  }
}

}  // namespace

PicturePaths picture_paths(const Options& options, const Inputs& inputs) {
  PicturePaths paths;
  if (options.html) {
    name_pages(*options.html, inputs, paths);
  }
  if (options.field_export.file) {
    name_fields(*options.field_export.file, inputs, paths);
  }
  if (options.separation_ply) {
    const fs::path folder = *options.separation_ply;
    paths.separations = files_in(folder, file_names_of(inputs.files, ".ply"));
    // The folder without a final slash: `DIR/` becomes `DIR`.
    paths.folders.push_back((folder / "x").parent_path().string());
  }
  refuse_looked_at(paths.folders, options);
  return paths;
}

}  // namespace meshalyzer
