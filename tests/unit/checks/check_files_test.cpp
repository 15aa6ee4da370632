#include "meshalyzer/checks/check_files.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/checks/profile.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

std::vector<CheckJob> jobs_of(const std::vector<std::string>& names) {
  std::vector<CheckJob> jobs;
  for (const std::string& name : names) {
    jobs.push_back(
        {std::string(MESHALYZER_MESHES "/") + name, name, find_profile("solid")->criteria});
  }
  return jobs;
}

constexpr std::uint64_t kPlenty = std::uint64_t{1} << 30U;

TEST(CheckFiles, TellsOfEachInOrder) {
  std::string told;
  EXPECT_TRUE(check_files(jobs_of({"cube.mesh", "cube_with_hole.mesh", "torus.mesh"}), kPlenty,
                          [&](const FileFindings& file) {
                            told += file.path + (file.is_good() ? " good\n" : " not\n");
                            return true;
                          }));
  EXPECT_EQ(told, "cube.mesh good\ncube_with_hole.mesh not\ntorus.mesh good\n");
}

TEST(CheckFiles, UnreadableFileIsOneOfThem) {
  std::vector<FileFindings> told;
  EXPECT_TRUE(check_files(jobs_of({"broken/nan.mesh", "missing.stl", "cube.mesh"}), kPlenty,
                          [&](const FileFindings& file) {
                            told.push_back(file);
                            return true;
                          }));
  ASSERT_EQ(told.size(), 3U);
  EXPECT_EQ(told[0].error, "\"nan\" is not a finite number");
  EXPECT_EQ(told[0].error_place.line, 2U);
  EXPECT_FALSE(told[1].is_readable());
  EXPECT_FALSE(told[1].is_good());
  EXPECT_TRUE(told[2].is_good());
}

TEST(CheckFiles, EndsWhereTheListenerWantsNoMore) {
  int n_told = 0;
  EXPECT_FALSE(check_files(jobs_of({"cube.mesh", "torus.mesh"}), kPlenty,
                           [&](const FileFindings&) { return ++n_told < 1; }));
  EXPECT_EQ(n_told, 1);
}

TEST(CheckTotals, CountFilesAndFindings) {
  CheckTotals totals;
  static_cast<void>(check_files(jobs_of({"cube.mesh", "orphan_vertex.mesh", "tube.mesh", "no.obj"}),
                                kPlenty, [&](const FileFindings& file) {
                                  totals.add(file);
                                  return true;
                                }));
  EXPECT_EQ(totals.meshes, 4U);
  EXPECT_EQ(totals.good, 1U);
  EXPECT_EQ(totals.not_good, 2U);
  EXPECT_EQ(totals.unreadable, 1U);
  EXPECT_EQ(totals.errors, 2U);
  EXPECT_EQ(totals.warnings, 1U);
  EXPECT_EQ(totals.fixable, 3U);
}

TEST(CheckFiles, ReceiverThatIsNullIsRefused) {
  EXPECT_THROW(static_cast<void>(check_files({}, kPlenty, nullptr)), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
