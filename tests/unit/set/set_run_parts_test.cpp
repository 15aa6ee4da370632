#include "meshalyzer/set/set_run.h"
#include "recorded_run.h"
#include "support/packed_sets.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using test::asking_all;
using test::knowing;
using test::Recorder;
using test::SoupFiles;
using test::Told;

std::vector<Soup> packed() {
  return test::pack_tubes({.n_objects = 11,
                           .faces_per_object = 120,
                           .n_crossing = 2,
                           .n_touching = 1,
                           .n_contained = 1})
      .objects;
}

/// The calls and the result of a whole run.
struct Whole {
  Told told;
  std::string set;
};

Whole whole_run(const SoupFiles& files, const SetOptions& options) {
  Recorder recorder;
  const std::string set = test::described(analyze_set(files.paths(), options, recorder).value());
  return {recorder.told, set};
}

/// Returns the calls of the runs of all shards.
std::vector<Told> shard_runs(const SoupFiles& files, SetOptions options, std::size_t count) {
  std::vector<Told> parts;
  for (std::size_t number = 0; number < count; ++number) {
    options.shard = {.number = number, .count = count};
    Recorder recorder;
    EXPECT_EQ(analyze_set(files.paths(), options, recorder).has_value(), count == 1);
    parts.push_back(recorder.told);
  }
  return parts;
}

Told together(const std::vector<Told>& parts) {
  Told all;
  for (const Told& part : parts) {
    all.add(part);
  }
  return all;
}

/// Returns findings as they are read back from where they were written.
Told without_values(Told told) {
  for (auto& [number, mesh] : told.meshes) {
    mesh.values = {};
  }
  return told;
}

TEST(AnalyzeSetInShards, AllOfThemTellWhatTheWholeTells) {
  SoupFiles files(packed());
  files.add("bad.mesh", "Vertex 1 0 0\n");
  SetOptions options = asking_all();
  options.request.between.force = true;
  const Whole whole = whole_run(files, options);
  for (const std::size_t count : {1U, 2U, 3U, 20U}) {
    SCOPED_TRACE(count);
    const std::vector<Told> parts = shard_runs(files, options, count);
    EXPECT_TRUE(together(parts).text() == whole.told.text());
    std::size_t n_meshes = 0;
    std::size_t n_findings = 0;
    for (const Told& part : parts) {
      n_meshes += part.meshes.size() + part.troubles.size();
      n_findings += part.findings.size();
    }
    // Each is told once.
    EXPECT_EQ(n_meshes, files.paths().size());
    EXPECT_EQ(n_findings, whole.told.findings.size());
  }
}

TEST(AnalyzeSetInShards, WorkIsSharedOut) {
  const SoupFiles files(packed());
  for (const Told& part : shard_runs(files, asking_all(), 3)) {
    EXPECT_GE(part.meshes.size(), 3U);
    EXPECT_GE(part.findings.size(), 3U);
  }
}

TEST(AnalyzeSetInShards, WhatTheyToldMakesTheAnalysisOfTheWhole) {
  const SoupFiles files(packed());
  const Whole whole = whole_run(files, asking_all());
  Recorder recorder;
  recorder.known = without_values(together(shard_runs(files, asking_all(), 3)));
  const auto set = analyze_set(files.paths(), knowing(recorder, asking_all()), recorder);
  EXPECT_TRUE(test::described(set.value()) == whole.set);
  EXPECT_TRUE(recorder.told.text() == whole.told.text());
}

TEST(AnalyzeSetInShards, MeshOfAnotherShardThatIsNotGoodForbidsSeparationInTheEnd) {
  // The first shard, which has the files 0 and 2, does not know of it.
  const SoupFiles files({shapes::cube(), shapes::translated(shapes::open_cube(), {3, 0, 0}),
                         shapes::cube(1.0, {6, 0, 0})});
  const std::vector<Told> parts = shard_runs(files, asking_all(), 2);
  EXPECT_TRUE(parts[0].findings.begin()->second.separation.has_value());
  EXPECT_FALSE(parts[1].findings.begin()->second.separation.has_value());
  Recorder recorder;
  recorder.known = without_values(together(parts));
  const SetAnalysis set =
      analyze_set(files.paths(), knowing(recorder, asking_all()), recorder).value();
  EXPECT_FALSE(set.separation.has_value());
  EXPECT_EQ(test::described(set), whole_run(files, asking_all()).set);
}

TEST(AnalyzeSetAgain, WhatIsKnownIsNotLookedForAgain) {
  SetOptions options = asking_all();
  options.request.between.statistics = false;
  Recorder recorder;
  std::string set;
  std::vector<std::string> paths;
  {
    SoupFiles files(packed());
    files.add("bad.mesh", "Vertex 1 0 0\n");
    options.request.between.force = true;
    const Whole whole = whole_run(files, options);
    recorder.known = without_values(whole.told);
    set = whole.set;
    paths = files.paths();
  }
  // The files are gone.
  ASSERT_FALSE(std::filesystem::exists(paths.front()));
  EXPECT_TRUE(test::described(analyze_set(paths, knowing(recorder, options), recorder).value()) ==
              set);
  EXPECT_TRUE(recorder.told.text() == recorder.known.text());
}

TEST(AnalyzeSetAgain, KnownPartOfARunIsCompleted) {
  const SoupFiles files(packed());
  const Whole whole = whole_run(files, asking_all());
  Recorder recorder;
  recorder.known = without_values(whole.told);
  for (const Index number : {0U, 4U, 9U}) {
    recorder.known.meshes.erase(number);
    recorder.known.findings.erase(number + 1);
  }
  EXPECT_TRUE(test::described(
                  analyze_set(files.paths(), knowing(recorder, asking_all()), recorder).value()) ==
              whole.set);
  EXPECT_TRUE(recorder.told.text() == whole.told.text());
}

TEST(AnalyzeSetAgain, StatisticsNeedTheFilesOfKnownMeshes) {
  Recorder recorder;
  std::vector<std::string> paths;
  {
    const SoupFiles files({shapes::cube()});
    recorder.known = whole_run(files, {}).told;
    paths = files.paths();
  }
  EXPECT_EQ(analyze_set(paths, knowing(recorder), recorder).value().unreadable, 1U);
  EXPECT_EQ(recorder.told.troubles.count(0), 1U);
}

TEST(AnalyzeSetAgain, KnownFindingsThatAreNotAskedForAreLeftOut) {
  const SoupFiles files(packed());
  Recorder recorder;
  recorder.known = without_values(whole_run(files, asking_all()).told);
  SetOptions intersections = asking_all();
  intersections.request.between.separation.reset();
  const SetAnalysis met =
      analyze_set(files.paths(), knowing(recorder, intersections), recorder).value();
  EXPECT_EQ(test::described(met), whole_run(files, intersections).set);
  SetOptions separation = asking_all();
  separation.request.between.intersections = false;
  const SetAnalysis measured =
      analyze_set(files.paths(), knowing(recorder, separation), recorder).value();
  EXPECT_EQ(test::described(measured), whole_run(files, separation).set);
}

}  // namespace
}  // namespace meshalyzer
