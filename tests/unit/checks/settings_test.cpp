#include "meshalyzer/checks/settings.h"

#include "meshalyzer/base/error.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace meshalyzer {
namespace {

/// Returns the error of a settings file.
std::string fault_of(std::string_view text) {
  try {
    static_cast<void>(parse_settings(text, "dir/.meshalyzer.toml"));
  } catch (const IoError& error) {
    return error.what();
  }
  return "nothing";
}

CheckCriteria criteria_from(std::string_view text, const std::string& path,
                            const CheckSettings& command_line = {}) {
  const SettingsFile file = parse_settings(text, "dir/.meshalyzer.toml");
  return criteria_for(path, &file, command_line);
}

TEST(ParseSettings, KeysAreThoseOfTheCommandLine) {
  const SettingsFile file = parse_settings(
      "profile = 'print'\nselect = ['hole']\nignore = ['slit', 'numbering']\nmax = 0\n"
      "max-aspect-ratio = 20\nmin-corner-angle = 2.5\nexclude = ['old/*']\n",
      "dir/.meshalyzer.toml");
  EXPECT_EQ(file.folder, "dir");
  EXPECT_EQ(file.settings.profile, "print");
  EXPECT_EQ(file.settings.selected, (std::vector<std::string>{"hole"}));
  EXPECT_EQ(file.settings.ignored, (std::vector<std::string>{"slit", "numbering"}));
  EXPECT_EQ(file.settings.max_listed, 0U);
  EXPECT_EQ(file.settings.limits[LimitKind::MaxAspectRatio], 20.0);
  EXPECT_EQ(file.settings.limits[LimitKind::MinCornerAngle], 2.5);
  EXPECT_EQ(file.excluded, (std::vector<std::string>{"old/*"}));
}

TEST(ParseSettings, WrongKeyIsNamedWithItsLineAndTheNearestRightOne) {
  EXPECT_EQ(fault_of("profile = 'solid'\nmax-aspect-ration = 3\n"),
            "dir/.meshalyzer.toml:2: unknown key 'max-aspect-ration'; did you mean "
            "'max-aspect-ratio'?");
  EXPECT_EQ(fault_of("[[files]]\npath = 'a'\nexclude = ['b']\n"),
            "dir/.meshalyzer.toml:3: unknown key 'exclude'");
}

TEST(ParseSettings, WrongValuesAreRefused) {
  EXPECT_EQ(fault_of("profile = 'sold'"),
            "dir/.meshalyzer.toml:1: no profile is called 'sold'; did you mean 'solid'?");
  EXPECT_EQ(fault_of("ignore = ['holes']"),
            "dir/.meshalyzer.toml:1: no code is called 'holes'; did you mean 'hole'?");
  EXPECT_EQ(fault_of("\nmax = -1"),
            "dir/.meshalyzer.toml:2: a whole number, 0 or more, should stand here");
  EXPECT_EQ(fault_of("max-faces = 'many'"), "dir/.meshalyzer.toml:1: a number should stand here");
  for (const char* const text : {"\nmax-faces = nan", "\nmax-faces = -nan"}) {
    EXPECT_EQ(fault_of(text), "dir/.meshalyzer.toml:2: a number should stand here");
  }
  EXPECT_EQ(fault_of("max-faces = inf"), "nothing");
  EXPECT_EQ(fault_of("ignore = 'hole'"),
            "dir/.meshalyzer.toml:1: a list of texts should stand here: [\"...\"]");
  EXPECT_EQ(fault_of("[[files]]\nprofile = 'sheet'"),
            "dir/.meshalyzer.toml:1: a section [[files]] needs a path");
}

TEST(ParseSettings, WhatIsNoTomlIsRefusedWithItsLine) {
  EXPECT_EQ(fault_of("max = 1\nmax ==").substr(0, 24), "dir/.meshalyzer.toml:2: ");
}

TEST(CriteriaFor, SectionsHoldForTheFilesTheyFitAndTheCommandLineForAll) {
  constexpr std::string_view kText =
      "max-faces = 9\n[[files]]\npath = 'terrain/*.ply'\nprofile = 'sheet'\nmax-faces = 5\n";
  const CheckCriteria terrain = criteria_from(kText, "dir/terrain/a.ply");
  EXPECT_FALSE(terrain.codes.contains(DefectCode::Hole));
  EXPECT_EQ(terrain.limits[LimitKind::MaxFaces], 5.0);
  const CheckCriteria other = criteria_from(kText, "dir/a.ply");
  EXPECT_TRUE(other.codes.contains(DefectCode::Hole));
  EXPECT_EQ(other.limits[LimitKind::MaxFaces], 9.0);
  CheckSettings command_line;
  command_line.limits[LimitKind::MaxFaces] = 7;
  EXPECT_EQ(criteria_from(kText, "dir/terrain/a.ply", command_line).limits[LimitKind::MaxFaces],
            7.0);
}

TEST(CriteriaFor, IgnoredCodesAddUp) {
  CheckSettings command_line;
  command_line.ignored = {"slit"};
  const CheckCriteria criteria = criteria_from("ignore = ['hole']", "dir/a.ply", command_line);
  EXPECT_FALSE(criteria.codes.contains(DefectCode::Hole));
  EXPECT_FALSE(criteria.codes.contains(DefectCode::Slit));
}

TEST(IsExcluded, PatternsAreRelativeToTheSettingsFile) {
  const SettingsFile file = parse_settings("exclude = ['old/*', '*.off']", "dir/.meshalyzer.toml");
  EXPECT_TRUE(is_excluded(file, "dir/old/a.ply"));
  EXPECT_TRUE(is_excluded(file, "dir/deep/a.off"));
  EXPECT_FALSE(is_excluded(file, "dir/a.ply"));
}

TEST(IsExcluded, PatternThatFitsAFolderIsForAllFilesInIt) {
  const SettingsFile file =
      parse_settings("exclude = ['old', 'scans/raw/', 'a/*']", "dir/.meshalyzer.toml");
  EXPECT_TRUE(is_excluded(file, "dir/new/old/deep/a.ply"));
  EXPECT_TRUE(is_excluded(file, "dir/scans/raw/a.ply"));
  EXPECT_TRUE(is_excluded(file, "dir/a/b/c.ply"));
  EXPECT_FALSE(is_excluded(file, "dir/scans/a.ply"));
  EXPECT_FALSE(is_excluded(file, "dir/older/a.ply"));
}

TEST(FindSettingsFile, NearestFolderAboveCounts) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.file("a/b"));
  std::ofstream(folder.file(".meshalyzer.toml")).flush();
  EXPECT_EQ(find_settings_file(folder.file("a/b/c.ply")), folder.file(".meshalyzer.toml"));
  std::ofstream(folder.file("a/.meshalyzer.toml")).flush();
  EXPECT_EQ(find_settings_file(folder.file("a/b/c.ply")), folder.file("a/.meshalyzer.toml"));
}

TEST(FindSettingsFile, WhatCannotBeReadIsFoundAndRefusedByTheReader) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.file("a"));
  std::ofstream(folder.file(".meshalyzer.toml")).flush();
  const std::string loop = folder.file("a/.meshalyzer.toml");
  std::filesystem::create_symlink(loop, loop);
  EXPECT_EQ(find_settings_file(folder.file("a/c.ply")), loop);
  EXPECT_THROW(static_cast<void>(read_settings_file(loop)), IoError);
}

}  // namespace
}  // namespace meshalyzer
