#include "meshalyzer/io/file_replacement.h"

#include "io_cases.h"
#include "meshalyzer/base/error.h"
#include "support/file_size_limit.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace meshalyzer {
namespace {

/// More than any buffer of ours, so that some of it is in the file before the end.
const std::string kLong(3000000, 'n');

TEST(FileReplacement, PiecesFollowOneAnotherWhateverTheirLength) {
  const TemporaryFolder folder;
  std::string all;
  FileReplacement file(folder.file("a"));
  for (const std::size_t length : {1U, 300000U, 0U, 7U, 200000U, 200000U, 1000000U, 3U}) {
    const std::string piece(length, static_cast<char>('a' + all.size() % 26));
    file.write(piece);
    all += piece;
  }
  file.commit();
  EXPECT_EQ(read_bytes(folder.file("a")), all);
  EXPECT_EQ(folder.n_entries(), 1);
}

TEST(FileReplacement, TheOldFileStaysUntilTheCommit) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), "old");
  FileReplacement file(folder.file("a"));
  file.write(kLong);
  EXPECT_EQ(read_bytes(folder.file("a")), "old");
  file.commit();
  EXPECT_EQ(read_bytes(folder.file("a")), kLong);
}

TEST(FileReplacement, WithoutACommitNothingHasHappened) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), "old");
  {
    FileReplacement file(folder.file("a"));
    file.write(kLong);
  }
  EXPECT_EQ(read_bytes(folder.file("a")), "old");
  EXPECT_EQ(folder.n_entries(), 1);
}

TEST(FileReplacement, NothingWrittenMakesAnEmptyFile) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), "old");
  FileReplacement(folder.file("a")).commit();
  EXPECT_EQ(read_bytes(folder.file("a")), "");
}

TEST(FileReplacement, GoesOnWhereItIsMovedTo) {
  const TemporaryFolder folder;
  FileReplacement first(folder.file("a"));
  first.write("be");
  FileReplacement second = std::move(first);
  second.write("gin");
  second.commit();
  EXPECT_EQ(read_bytes(folder.file("a")), "begin");
}

TEST(FileReplacement, TwoInOneFolderDoNotMeet) {
  const TemporaryFolder folder;
  FileReplacement a(folder.file("a"));
  FileReplacement b(folder.file("b"));
  a.write("of a");
  b.write("of b");
  b.commit();
  a.commit();
  EXPECT_EQ(read_bytes(folder.file("a")), "of a");
  EXPECT_EQ(read_bytes(folder.file("b")), "of b");
}

TEST(FileReplacement, APipeIsWrittenIntoWhileItIsRead) {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = read_bytes(pipe); });
  FileReplacement file(pipe);
  file.write(kLong);
  file.write("end");
  file.commit();
  reader.join();
  EXPECT_EQ(received, kLong + "end");
  EXPECT_EQ(folder.n_entries(), 1);
}

TEST(FileReplacement, AfterAnErrorNothingCanBeCommitted) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  write_bytes(path, "old");
  FileReplacement file(path);
  file.write("begin");
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = error_of([&] {
      file.write(kLong);
      return 0;
    });
  }
  EXPECT_EQ(message, path + ": cannot be written: File too large");
  EXPECT_EQ(folder.n_entries(), 1);
  EXPECT_THROW(file.write("more"), InvalidArgument);
  EXPECT_THROW(file.commit(), InvalidArgument);
  EXPECT_EQ(read_bytes(path), "old");
}

TEST(FileReplacement, WhatIsBufferedFailsAtTheCommit) {
  FileReplacement file("/dev/full");
  file.write("a few");
  EXPECT_THROW(file.commit(), IoError);
}

TEST(FileReplacement, AnOpenFileIsWrittenOnFromItsPosition) {
  for (const int flag : {0, O_APPEND}) {
    const TemporaryFolder folder;
    write_bytes(folder.file("a"), "a log");
    const int log = ::open(folder.file("a").c_str(), O_WRONLY | flag);
    const std::string name = "/dev/fd/" + std::to_string(log);
    ASSERT_EQ(::symlink(name.c_str(), folder.file("link").c_str()), 0);
    ASSERT_EQ(::lseek(log, 5, SEEK_SET), 5);
    for (const std::string& path : {name, folder.file("link")}) {
      FileReplacement file(path);
      file.write(", more");
      file.commit();
    }
    ASSERT_EQ(::write(log, ".", 1), 1);
    ::close(log);
    EXPECT_EQ(read_bytes(folder.file("a")), "a log, more, more.");
    EXPECT_EQ(folder.n_entries(), 2);
  }
}

std::string copy_error(const std::string& from, const std::string& to) {
  return error_of([&] {
    copy_to_new_file(from, to);
    return 0;
  });
}

TEST(CopyToNewFile, HasTheContentAndThePermissions) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), kLong);
  ASSERT_EQ(::chmod(folder.file("a").c_str(), 0640), 0);
  copy_to_new_file(folder.file("a"), folder.file("copy"));
  EXPECT_EQ(read_bytes(folder.file("copy")), kLong);
  struct stat status {};
  ASSERT_EQ(::stat(folder.file("copy").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST(CopyToNewFile, LeavesNoPartOfACopy) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), kLong);
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = copy_error(folder.file("a"), folder.file("copy"));
  }
  EXPECT_EQ(message, folder.file("copy") + ": cannot be written: File too large");
  EXPECT_EQ(folder.n_entries(), 1);
}

TEST(CopyToNewFile, ReplacesNothing) {
  const TemporaryFolder folder;
  write_bytes(folder.file("a"), "of a");
  write_bytes(folder.file("b"), "of b");
  ASSERT_EQ(::symlink("nothing", folder.file("link").c_str()), 0);
  for (const char* name : {"b", "link"}) {
    EXPECT_EQ(copy_error(folder.file("a"), folder.file(name)),
              folder.file(name) + ": cannot be written: File exists");
  }
  EXPECT_EQ(read_bytes(folder.file("b")), "of b");
  EXPECT_EQ(folder.n_entries(), 3);
}

TEST(FileReplacement, EndsWithTheCommit) {
  const TemporaryFolder folder;
  FileReplacement file(folder.file("a"));
  file.commit();
  EXPECT_THROW(file.write("more"), InvalidArgument);
  EXPECT_THROW(file.commit(), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
