#include "inputs.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace meshalyzer {
namespace {

namespace fs = std::filesystem;

bool has_mesh_ending(const fs::path& path) {
  constexpr std::array<std::string_view, 5> kEndings{".mesh", ".obj", ".off", ".stl", ".ply"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

void add_folder(Inputs& inputs, const std::string& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;  // an entry that cannot be looked at is told of when it is read
    const fs::file_status status = entry->status(ignored);
    if (has_mesh_ending(entry->path()) && !fs::is_directory(status) && !fs::is_other(status)) {
      names.push_back(entry->path().filename().string());
    }
  }
  if (error) {
    inputs.troubles.push_back(folder + ": cannot list the folder: " + error.message());
  } else if (names.empty()) {
    inputs.troubles.push_back(folder + ": no mesh file in the folder (.mesh .obj .off .stl .ply)");
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    inputs.files.push_back((fs::path(folder) / name).string());
  }
}

}  // namespace

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

Inputs find_inputs(const std::vector<std::string>& paths) {
  Inputs inputs;
  for (const std::string& path : paths) {
    if (is_folder(path)) {
      inputs.is_set = true;
      add_folder(inputs, path);
    } else {
      inputs.files.push_back(path);
    }
  }
  return inputs;
}

}  // namespace meshalyzer
