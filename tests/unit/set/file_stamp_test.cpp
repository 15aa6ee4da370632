#include "meshalyzer/set/file_stamp.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

namespace meshalyzer {
namespace {

TEST(StampOf, FileThatIsNotThereHasNone) {
  const TemporaryFolder folder;
  EXPECT_EQ(stamp_of(folder.file("a.mesh")), FileStamp());
}

TEST(StampOf, TellsTheSizeAndTheTimeOfTheLastChange) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.mesh");
  write_bytes(path, "12345");
  const FileStamp stamp = stamp_of(path);
  EXPECT_EQ(stamp.bytes, 5U);
  using std::chrono::nanoseconds;
  using std::chrono::system_clock;
  const auto now = std::chrono::duration_cast<nanoseconds>(system_clock::now().time_since_epoch());
  EXPECT_NEAR(static_cast<double>(stamp.modified_ns), static_cast<double>(now.count()), 60e9);
  EXPECT_EQ(stamp_of(path), stamp);
}

TEST(StampOf, OtherSizeOrOtherTimeIsAnotherStamp) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.mesh");
  write_bytes(path, "12345");
  const FileStamp before = stamp_of(path);
  const auto time = std::filesystem::last_write_time(path);
  std::filesystem::last_write_time(path, time + std::chrono::microseconds(1));
  EXPECT_EQ(stamp_of(path).bytes, before.bytes);
  EXPECT_NE(stamp_of(path), before);
  write_bytes(path, "123456");
  std::filesystem::last_write_time(path, time);
  EXPECT_NE(stamp_of(path), before);
}

}  // namespace
}  // namespace meshalyzer
