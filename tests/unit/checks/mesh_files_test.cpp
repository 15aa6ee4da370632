#include "meshalyzer/checks/mesh_files.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace meshalyzer {
namespace {

namespace fs = std::filesystem;

/// A folder with empty files.
class MeshFilesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"b.stl", "a.ply", "notes.txt", "old/c.OBJ", "old/deep/d.off",
                             ".hidden/e.stl", ".f.stl"}) {
      const fs::path path = fs::path(folder_.path()) / name;
      fs::create_directories(path.parent_path());
      std::ofstream(path).flush();
    }
  }

  [[nodiscard]] std::vector<std::string> found(const std::vector<std::string>& excluded) const {
    std::vector<std::string> names;
    for (const std::string& file : find_mesh_files({folder_.path()}, excluded).files) {
      names.push_back(fs::path(file).lexically_relative(folder_.path()).string());
    }
    return names;
  }

  TemporaryFolder folder_;
};

TEST_F(MeshFilesTest, FolderIsSearchedAsDeepAsItGoesButForWhatIsHidden) {
  EXPECT_EQ(found({}), (std::vector<std::string>{"a.ply", "b.stl", "old/c.OBJ", "old/deep/d.off"}));
}

TEST_F(MeshFilesTest, ExcludedFilesAndFoldersAreLeftOut) {
  EXPECT_EQ(found({"*.stl", "deep"}), (std::vector<std::string>{"a.ply", "old/c.OBJ"}));
  EXPECT_EQ(found({"old/deep/"}), (std::vector<std::string>{"a.ply", "b.stl", "old/c.OBJ"}));
  EXPECT_EQ(found({"old/*.OBJ"}), (std::vector<std::string>{"a.ply", "b.stl", "old/deep/d.off"}));
}

TEST_F(MeshFilesTest, NamedFileIsTakenWhateverItIsCalled) {
  const std::vector<std::string> paths{"-", folder_.file(".f.stl")};
  EXPECT_EQ(find_mesh_files(paths, {"*.stl"}).files, paths);
}

TEST_F(MeshFilesTest, FolderWithoutMeshesIsAnError) {
  fs::create_directory(folder_.file("empty"));
  const MeshFiles files = find_mesh_files({folder_.file("empty")}, {});
  ASSERT_EQ(files.errors.size(), 1U);
  EXPECT_NE(files.errors[0].find("empty: no mesh file"), std::string::npos);
}

TEST_F(MeshFilesTest, FoldersWithinThatCannotBeListedAreErrors) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may list every folder";
  const std::string locked = folder_.file("old/deep");
  fs::permissions(locked, fs::perms::none);
  const MeshFiles files = find_mesh_files({folder_.path()}, {});
  fs::permissions(locked, fs::perms::owner_all);
  EXPECT_EQ(files.files, (std::vector<std::string>{folder_.file("a.ply"), folder_.file("b.stl"),
                                                   folder_.file("old/c.OBJ")}));
  EXPECT_EQ(files.errors,
            std::vector<std::string>{locked + ": cannot list the folder: Permission denied"});
}

TEST_F(MeshFilesTest, FolderOfWhichAllMeshesAreExcludedIsNoErrorButCounted) {
  // Without a pattern, a.ply, b.stl, old/c.OBJ and old/deep/d.off are found.
  const MeshFiles files = find_mesh_files({folder_.path()}, {"*"});
  EXPECT_TRUE(files.files.empty());
  EXPECT_TRUE(files.errors.empty());
  EXPECT_EQ(files.n_excluded, 4U);
  fs::create_directory(folder_.file("empty"));
  EXPECT_EQ(find_mesh_files({folder_.file("empty")}, {"*"}).errors.size(), 1U);
}

TEST_F(MeshFilesTest, LinksToFoldersAreNotFollowed) {
  fs::create_directory_symlink(folder_.path(), folder_.file("old/loop"));
  EXPECT_EQ(found({}), (std::vector<std::string>{"a.ply", "b.stl", "old/c.OBJ", "old/deep/d.off"}));
}

TEST(MatchesGlob, PatternWithoutSlashIsForTheName) {
  EXPECT_TRUE(matches_glob("*.ply", "deep/in/a.ply"));
  EXPECT_FALSE(matches_glob("in", "deep/in/a.ply"));
  EXPECT_TRUE(matches_glob("deep/*/a.ply", "deep/in/a.ply"));
  EXPECT_FALSE(matches_glob("deep/*.ply", "deep/in/a.ply"));
}

TEST(MatchesGlob, SlashAtTheEndCountsForNothing) {
  EXPECT_TRUE(matches_glob("in/", "deep/in"));
  EXPECT_TRUE(matches_glob("deep/in/", "deep/in"));
  EXPECT_FALSE(matches_glob("in/", "deep/in/a.ply"));
}

}  // namespace
}  // namespace meshalyzer
