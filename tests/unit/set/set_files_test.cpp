#include "meshalyzer/set/set_files.h"

#include "meshalyzer/base/error.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

TEST(SetNames, AreTheLastPartsOfPathsWhereTheseDiffer) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(set_names({"/a/x.mesh", "b/y.mesh", "z.mesh"}), (Names{"x.mesh", "y.mesh", "z.mesh"}));
  EXPECT_EQ(set_names({"/a/x.mesh", "/b/x.mesh", "z.mesh"}),
            (Names{"/a/x.mesh", "/b/x.mesh", "z.mesh"}));
  EXPECT_EQ(set_names({}), Names{});
}

/// Two files of a folder, and their paths.
struct TwoFiles {
  TwoFiles() {
    write_bytes(paths[0], "one");
    write_bytes(paths[1], "two");
  }
  TemporaryFolder folder;
  std::vector<std::string> paths{folder.file("a.mesh"), folder.file("b.mesh")};
};

TEST(Stamped, FingerprintIsTheSameAsLongAsTheFilesAre) {
  const TwoFiles files;
  EXPECT_EQ(stamped(files.paths).fingerprint, stamped(files.paths).fingerprint);
  EXPECT_EQ(stamped(files.paths).fingerprint.size(), 16U);
}

TEST(Stamped, FingerprintTellsSizes) {
  const TwoFiles files;
  const SetFiles before = stamped(files.paths);
  const auto time = std::filesystem::last_write_time(files.paths[1]);
  write_bytes(files.paths[1], "three");
  std::filesystem::last_write_time(files.paths[1], time);
  EXPECT_NE(stamped(files.paths).fingerprint, before.fingerprint);
}

TEST(Stamped, FingerprintTellsTimes) {
  const TwoFiles files;
  const SetFiles before = stamped(files.paths);
  std::filesystem::last_write_time(files.paths[0], std::filesystem::file_time_type{});
  EXPECT_NE(stamped(files.paths).fingerprint, before.fingerprint);
}

TEST(Stamped, FingerprintTellsPathsAndTheirOrder) {
  const TwoFiles files;
  const std::string whole = stamped(files.paths).fingerprint;
  EXPECT_NE(stamped({files.paths[1], files.paths[0]}).fingerprint, whole);
  EXPECT_NE(stamped({files.paths[0]}).fingerprint, whole);
}

TEST(RequireUnchanged, NamesTheFileThatIsNotWhatItWas) {
  const TwoFiles files;
  const SetFiles before = stamped(files.paths);
  EXPECT_NO_THROW(require_unchanged(before));
  std::filesystem::remove(files.paths[1]);
  try {
    require_unchanged(before);
    FAIL();
  } catch (const IoError& error) {
    EXPECT_EQ(std::string(error.what()).find(files.paths[1] + ": is not there"), 0U);
  }
}

}  // namespace
}  // namespace meshalyzer
