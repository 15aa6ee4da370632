#include "meshalyzer/io/read.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

bool is_mesh_file(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const std::vector<std::string> endings{".mesh", ".obj", ".off", ".stl", ".ply"};
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// The mesh files of the corpus, in name order; those in `unreadable` are no meshes.
std::vector<std::filesystem::path> corpus_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(MESHALYZER_CORPUS)) {
    const bool is_unreadable = entry.path().parent_path().filename() == "unreadable";
    if (entry.is_regular_file() && is_mesh_file(entry.path()) && !is_unreadable)
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(CorpusBuild, EveryRealMeshIsHeldFaithfully) {
  if (!std::filesystem::is_directory(MESHALYZER_CORPUS)) {
    GTEST_SKIP() << "no corpus at " << MESHALYZER_CORPUS;
  }
  const auto files = corpus_files();
  EXPECT_FALSE(files.empty());
  for (const auto& file : files) {
    SCOPED_TRACE(file.string());
    const Soup soup = read_mesh(file.string());
    EXPECT_EQ(validate(build(soup), soup), std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace meshalyzer
