#include "meshalyzer/set/analyze_files.h"

#include "recorded_run.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using test::knowing;
using test::Recorder;
using test::SoupFiles;
using Calls = std::vector<std::string>;

SoupFiles two_files() {
  return SoupFiles({shapes::cube(), shapes::open_cube()});
}

TEST(AnalyzeFiles, TellsOfEachFileInOrderAndOfNothingBetween) {
  SoupFiles files = two_files();
  files.add("bad.mesh", "Vertex 1 0 0\n");
  Recorder recorder;
  EXPECT_TRUE(analyze_files(files.paths(), test::asking_all(), recorder));
  EXPECT_EQ(recorder.calls, (Calls{"mesh 0", "files 1/3 12", "mesh 1", "files 2/3 22", "trouble 2",
                                   "files 3/3 22"}));
}

TEST(AnalyzeFiles, KeepsNoValuesForStatisticsOfASet) {
  const SoupFiles files = two_files();
  Recorder recorder;
  EXPECT_TRUE(analyze_files(files.paths(), test::asking_all(), recorder));
  EXPECT_TRUE(recorder.told.meshes.at(0).values.face_area.empty());
}

TEST(AnalyzeFiles, WhatIsKnownIsNotLookedForAgain) {
  Recorder recorder;
  std::vector<std::string> paths;
  {
    const SoupFiles files = two_files();
    Recorder earlier;
    EXPECT_TRUE(analyze_files(files.paths(), {}, earlier));
    recorder.known = earlier.told;
    paths = files.paths();
  }
  EXPECT_TRUE(analyze_files(paths, knowing(recorder), recorder));
  EXPECT_TRUE(recorder.told.text() == recorder.known.text());
}

TEST(AnalyzeFiles, ShardTellsItsOwnFilesAndIsNotTheWhole) {
  const SoupFiles files = two_files();
  SetOptions options;
  options.shard = {.number = 1, .count = 2};
  Recorder recorder;
  EXPECT_FALSE(analyze_files(files.paths(), options, recorder));
  EXPECT_EQ(recorder.told.meshes.count(0), 0U);
  EXPECT_EQ(recorder.told.meshes.count(1), 1U);
}

}  // namespace
}  // namespace meshalyzer
