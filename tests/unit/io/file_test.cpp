#include "meshalyzer/io/file.h"

#include "io_cases.h"
#include "support/file_size_limit.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace meshalyzer {
namespace {

std::string open_error(const std::string& path) {
  return error_of([&] { return FileContent(path).bytes().size(); });
}

std::string replace_error(const std::string& path, const std::string& bytes) {
  return error_of([&] {
    replace_file(path, bytes);
    return 0;
  });
}

struct stat status_of_file(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0);
  return status;
}

TEST(FileContent, HoldsTheBytesOfAFile) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), std::string("a\0b\r\n", 5));
  EXPECT_EQ(FileContent(folder.file("a")).bytes(), std::string_view("a\0b\r\n", 5));
}

TEST(FileContent, OfAnEmptyFileIsEmpty) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), "");
  EXPECT_EQ(FileContent(folder.file("a")).bytes(), "");
}

TEST(FileContent, ReadsAPipeToItsEnd) {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string bytes(3000000, 'x');
  std::thread writer([&] { write_bytes(pipe, bytes); });
  EXPECT_EQ(FileContent(pipe).bytes(), bytes);
  writer.join();
}

TEST(FileContent, ReadsADevice) {
  EXPECT_EQ(FileContent("/dev/null").bytes(), "");
}

TEST(FileContent, WhatCannotBeOpenedIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(open_error(folder.file("none")),
            folder.file("none") + ": cannot be opened: No such file or directory");
  EXPECT_EQ(open_error(folder.path()), folder.path() + ": is a directory");
}

TEST(ReplaceFile, MakesANewFileAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  replace_file(folder.file("a"), "new");
  EXPECT_EQ(read_bytes(folder.file("a")), "new");
  EXPECT_EQ(folder.n_entries(), 1);
}

TEST(ReplaceFile, KeepsThePermissionsOfTheOldFile) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), "old");
  std::filesystem::permissions(folder.file("a"), std::filesystem::perms(0640));
  replace_file(folder.file("a"), "new");
  EXPECT_EQ(read_bytes(folder.file("a")), "new");
  EXPECT_EQ(std::filesystem::status(folder.file("a")).permissions(), std::filesystem::perms(0640));
}

TEST(ReplaceFile, KeepsTheOwnerAndTheGroupOfTheOldFile) {
  if (::geteuid() != 0) GTEST_SKIP() << "only the superuser can give a file away";
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), "old");
  ASSERT_EQ(::chown(folder.file("a").c_str(), 1234, 5678), 0);
  replace_file(folder.file("a"), "new");
  const struct stat status = status_of_file(folder.file("a"));
  EXPECT_EQ(read_bytes(folder.file("a")), "new");
  EXPECT_EQ(status.st_uid, 1234U);
  EXPECT_EQ(status.st_gid, 5678U);
}

TEST(ReplaceFile, GivesNoOtherGroupWhatOnlyTheOldOneMayDo) {
  if (::geteuid() != 0) GTEST_SKIP() << "only the superuser can give a file away";
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), "old");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
  ASSERT_EQ(::chown(folder.file("a").c_str(), 1234, 5678), 0);
  ASSERT_EQ(::chmod(folder.file("a").c_str(), 0664), 0);
  ASSERT_EQ(::seteuid(1234), 0);
  replace_file(folder.file("a"), "new");
  ASSERT_EQ(::seteuid(0), 0);
  const struct stat status = status_of_file(folder.file("a"));
  EXPECT_EQ(status.st_uid, 1234U);
  EXPECT_EQ(status.st_mode & 0777U, 0644U);
}

TEST(ReplaceFile, ReplacesWhatASymbolicLinkPointsTo) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), "old");
  std::filesystem::create_symlink("a", folder.file("link"));
  replace_file(folder.file("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_EQ(read_bytes(folder.file("a")), "new");
}

TEST(ReplaceFile, MakesTheFileThatADanglingLinkPointsTo) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("sub"));
  std::filesystem::create_symlink("sub/link", folder.file("link"));
  std::filesystem::create_symlink("../a", folder.file("sub/link"));
  replace_file(folder.file("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("sub/link")));
  EXPECT_EQ(read_bytes(folder.file("a")), "new");
}

TEST(ReplaceFile, LinksThatLeadInACircleStay) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("b", folder.file("a"));
  std::filesystem::create_symlink("a", folder.file("b"));
  EXPECT_EQ(replace_error(folder.file("a"), "new"),
            folder.file("a") + ": cannot be written: Too many levels of symbolic links");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("a")));
  EXPECT_EQ(folder.n_entries(), 2);
}

TEST(ReplaceFile, AFailureLeavesTheOldFileAndNothingBeside) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  write_bytes(path, "old");
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = replace_error(path, std::string(5000, 'n'));
  }
  EXPECT_EQ(message, path + ": cannot be written: File too large");
  EXPECT_EQ(read_bytes(path), "old");
  EXPECT_EQ(folder.n_entries(), 1);
}

TEST(ReplaceFile, TheLongestNameHasRoomEnough) {
  const TemporaryFolder folder;
  const std::string path = folder.file(std::string(255, 'n'));
  replace_file(path, "new");
  EXPECT_EQ(read_bytes(path), "new");
}

TEST(ReplaceFile, AFullDeviceIsAnError) {
  EXPECT_EQ(replace_error("/dev/full", "new"),
            "/dev/full: cannot be written: No space left on device");
}

TEST(ReplaceFile, WhatCannotBeReplacedIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(replace_error(folder.path(), "new"), folder.path() + ": is a directory");
  const std::string nowhere = folder.file("none/a");
  EXPECT_EQ(replace_error(nowhere, "new"),
            nowhere + ": cannot be written: No such file or directory");
}

}  // namespace
}  // namespace meshalyzer
