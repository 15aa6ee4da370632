#include "meshalyzer/base/error.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/io/write.h"
#include "support/effort.h"
#include "support/random_file_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Larger ones only take longer.
constexpr std::uintmax_t kMaxBytes = 2'000'000;

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    const bool is_mesh = ending == ".mesh" || ending == ".obj" || ending == ".off" ||
                         ending == ".stl" || ending == ".ply";
    if (entry.is_regular_file() && is_mesh && entry.file_size() < kMaxBytes) {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The file as it is, and in every format.
std::vector<std::pair<std::string, std::string>> in_all_formats(const std::string& path) {
  std::vector<std::pair<std::string, std::string>> files;
  const FileContent content(path);
  files.emplace_back(path, content.bytes());
  const Soup soup = parse_mesh(content.bytes(), path);
  if (!soup.missing.empty() || soup.triangles.empty()) return files;
  for (const Format format : {Format::Mesh, Format::Obj, Format::Off, Format::Stl, Format::Ply}) {
    files.emplace_back("a." + std::string(format_name(format)), print_mesh(soup, format));
  }
  files.emplace_back("binary.ply", print_mesh(soup, Format::Ply, Encoding::Binary));
  files.emplace_back("binary.stl", print_mesh(soup, Format::Stl, Encoding::Binary));
  return files;
}

/// Calls `use` with every mesh at hand that can be written, in every format.
template <typename Use>
void for_each_file(Use use) {
  test::Effort share;
  for (const std::string folder : {MESHALYZER_MESHES, MESHALYZER_CORPUS}) {
    for (const std::string& path : files_in(folder)) {
      if (!share.runs_next()) continue;
      std::vector<std::pair<std::string, std::string>> files;
      try {
        files = in_all_formats(path);
      } catch (const Error&) {
        continue;  // broken on purpose
      }
      for (auto& [name, bytes] : files) {
        SCOPED_TRACE(path + " as " + name);
        EditedFile file(bytes, name);
        if (file.soup().missing.empty()) use(file);
      }
    }
  }
}

TEST(RewriteMesh, WithoutEditsEveryFileIsTheSameBytes) {
  for_each_file([](EditedFile& file) {
    const std::optional<RewrittenFile> written = file.rewritten();
    if (!written) return;
    EXPECT_TRUE(written->bytes == file.bytes());
    EXPECT_TRUE(written->file_faces.empty());
    EXPECT_TRUE(written->lost.empty());
  });
}

TEST(RewriteMesh, EditedFilesReadBackAsTheMeshThatWasWritten) {
  std::mt19937 random(20261122);
  const auto next = [&](std::size_t n) { return static_cast<Index>(random() % n); };
  for_each_file([&](EditedFile& file) {
    if (file.soup().triangles.empty()) return;
    edit_at_random(file, next);
    const std::optional<RewrittenFile> written = file.rewritten();
    if (!written) return;
    EXPECT_TRUE(says_what_was_written(file, *written, file.read_back()));
  });
}

TEST(RewriteAs, EditedFilesReadBackInEveryFormatAsTheMeshThatWasWritten) {
  std::mt19937 random(20261123);
  const auto next = [&](std::size_t n) { return static_cast<Index>(random() % n); };
  for_each_file([&](EditedFile& file) {
    if (file.soup().triangles.empty()) return;
    edit_at_random(file, next);
    for (const Format format : {Format::Mesh, Format::Obj, Format::Off, Format::Stl, Format::Ply}) {
      SCOPED_TRACE(std::string(format_name(format)));
      const RewrittenFile written = file.rewritten_as(format);
      const std::string name = "a." + std::string(format_name(format));
      EXPECT_TRUE(says_what_was_written(file, written, parse_mesh(written.bytes, name)));
    }
  });
}

}  // namespace
}  // namespace meshalyzer
