#include "meshalyzer/set/set_run.h"

#include "cube_at.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/set/analyze_files.h"
#include "meshalyzer/set/object_meeting.h"
#include "object_scene.h"
#include "recorded_run.h"
#include "support/constants.h"
#include "support/no_lengths.h"
#include "support/packed_sets.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using test::Recorder;
using test::SoupFiles;
using Calls = std::vector<std::string>;

constexpr std::uint64_t kMuchMemory = std::uint64_t{1} << 40;

SetOptions asking(bool intersections, bool separation, std::uint64_t memory_limit = kMuchMemory) {
  SetOptions options;
  options.request.between.intersections = intersections;
  if (separation) {
    options.request.between.separation.emplace();
  }
  options.memory_limit = memory_limit;
  return options;
}

SetOptions forced(SetOptions options) {
  options.request.between.force = true;
  return options;
}

SetAnalysis analyzed(const SoupFiles& files, const SetOptions& options) {
  Recorder recorder;
  return analyze_set(files.paths(), options, recorder).value();
}

/// Cubes with gaps of 1 in a row along x, the last one first.
std::vector<Soup> row_of_cubes(int n) {
  std::vector<Soup> cubes;
  for (int i = 0; i < n; ++i) {
    cubes.push_back(shapes::cube(1.0, {-2.0 * i, 0, 0}));
  }
  return cubes;
}

std::vector<Soup> packed(std::size_t n) {
  return test::pack_tubes({.n_objects = n,
                           .faces_per_object = 120,
                           .n_crossing = 2,
                           .n_touching = 1,
                           .n_contained = 1})
      .objects;
}

TEST(AnalyzeSet, TellsFilesInTheirOrderThenOwnersInTheOrderInSpace) {
  const SoupFiles files(row_of_cubes(3));
  Recorder recorder;
  EXPECT_TRUE(analyze_set(files.paths(), asking(true, true), recorder).has_value());
  EXPECT_EQ(recorder.calls, (Calls{"mesh 0", "files 1/3 12", "mesh 1", "files 2/3 24", "mesh 2",
                                   "files 3/3 36", "findings 2", "between 1/3 12", "findings 1",
                                   "between 2/3 24", "findings 0", "between 3/3 36"}));
}

TEST(AnalyzeSet, TellsNothingOfWhatIsBetweenWhereNotAsked) {
  const SoupFiles files(row_of_cubes(2));
  Recorder recorder;
  const SetAnalysis set = analyze_set(files.paths(), asking(false, false), recorder).value();
  EXPECT_EQ(recorder.calls, (Calls{"mesh 0", "files 1/2 12", "mesh 1", "files 2/2 24"}));
  EXPECT_FALSE(set.intersections.has_value());
  EXPECT_FALSE(set.separation.has_value());
  EXPECT_EQ(set.separation_reason, "");
}

TEST(AnalyzeSet, SameCallsAndResultForAnyThreadsAndMemory) {
  const SoupFiles files(packed(14));
  std::string calls;
  std::string set;
  for (const std::size_t n_threads : {1U, 2U, 5U}) {
    for (const std::uint64_t memory : {std::uint64_t{0}, kMuchMemory}) {
      const ThreadLimit limit(n_threads);
      Recorder recorder;
      const auto result = analyze_set(files.paths(), asking(true, true, memory), recorder);
      EXPECT_FALSE(recorder.was_called_at_once());
      calls = calls.empty() ? recorder.text : calls;
      set = set.empty() ? test::described(result.value()) : set;
      EXPECT_TRUE(recorder.text == calls) << n_threads << " threads, memory " << memory;
      EXPECT_TRUE(test::described(result.value()) == set) << n_threads << " threads";
    }
  }
  EXPECT_NE(calls.find("findings 13"), std::string::npos);
}

/// All pairs of objects, whatever their boxes and order in space.
SetIntersections intersections_of(const std::vector<Soup>& soups) {
  SetIntersections all;
  for (Index a = 0; a < soups.size(); ++a) {
    for (Index b = a + 1; b < soups.size(); ++b) {
      const ObjectMeeting meeting = find_meeting(SetObject(soups[a]), SetObject(soups[b]));
      for (const IntersectingPair& pair : meeting.pairs) {
        all.pairs.push_back({a, soups[a].face_ids.of(pair.face_a), b,
                             soups[b].face_ids.of(pair.face_b), pair.kind});
      }
      const auto add = [&](Inclusion inclusion, Index inner, Index outer) {
        if (inclusion != Inclusion::None) {
          (inclusion == Inclusion::Wholly ? all.contained : all.partly_contained)
              .push_back({inner, outer});
        }
      };
      add(meeting.first_in_second, a, b);
      add(meeting.second_in_first, b, a);
    }
  }
  std::sort(all.contained.begin(), all.contained.end());
  std::sort(all.partly_contained.begin(), all.partly_contained.end());
  return all;
}

TEST(AnalyzeSet, IntersectionsAreThoseOfAllPairsOfMeshes) {
  std::vector<Soup> soups = packed(12);
  // One that crosses many, with its own ids, and one half inside it.
  Soup large = shapes::cube(5.0, Vec3::Constant(-0.7));
  large.face_ids.first = 19;
  soups.insert(soups.begin() + 3, large);
  soups.push_back(shapes::merged(shapes::cube(0.125, Vec3(-0.6, -0.6, -0.6)),
                                 shapes::cube(0.125, Vec3(-20, -20, -20))));
  const SetIntersections expected = intersections_of(soups);
  const SetIntersections found =
      analyzed(SoupFiles(soups), asking(true, false)).intersections.value();
  EXPECT_EQ(found.pairs, expected.pairs);
  EXPECT_EQ(found.contained, expected.contained);
  EXPECT_EQ(found.partly_contained, expected.partly_contained);
  EXPECT_GT(found.pairs.size(), 50U);
  EXPECT_FALSE(found.contained.empty());
  EXPECT_EQ(found.partly_contained, (std::vector<ContainedMesh>{{13, 3}}));
}

TEST(AnalyzeSet, FindingsOfAnOwnerAreInOrder) {
  // The last one is the first in space, lies in the first one, and holds the second one; the third
  // one crosses it and numbers its faces backwards.
  std::vector<Soup> soups{cube_at(-2, 30), cube_at(0.25, 1), cube_at(1.5, 1), cube_at(-1, 3)};
  soups[2].face_ids.named = {12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1};
  const SoupFiles files(soups);
  Recorder recorder;
  (void)analyze_set(files.paths(), asking(true, false), recorder);
  const SetIntersections found = recorder.told.findings.at(3).intersections.value();
  EXPECT_EQ(found.contained, (std::vector<ContainedMesh>{{1, 3}, {3, 0}}));
  EXPECT_GT(found.pairs.size(), 3U);
  EXPECT_TRUE(std::is_sorted(found.pairs.begin(), found.pairs.end(),
                             [](const SetPair& p, const SetPair& q) {
                               return std::pair(p.face_a, p.face_b) < std::pair(q.face_a, q.face_b);
                             }));
  EXPECT_EQ(recorder.told.findings.at(1).intersections.value().contained,
            (std::vector<ContainedMesh>{{1, 0}}));
}

TEST(AnalyzeSet, SeparationIsThatOfEachObject) {
  const std::vector<Soup> soups = packed(10);
  const SoupFiles files(soups);
  SetOptions options = asking(false, true);
  options.request.between.separation =
      SeparationOptions{.search_radius = 0.5, .include_self = 0.25};
  Recorder recorder;
  (void)analyze_set(files.paths(), options, recorder);
  test::ObjectScene scene(soups);
  for (Index object = 0; object < soups.size(); ++object) {
    const ObjectFindings expected{object, std::nullopt,
                                  scene.measure(object, *options.request.between.separation)};
    EXPECT_EQ(test::described(recorder.told.findings.at(object)), test::described(expected));
  }
}

TEST(AnalyzeSet, UnreadableFileIsToldAndTheOthersAreDone) {
  SoupFiles files(row_of_cubes(2));
  files.add("bad.mesh", "Vertex 1 0 0\n");
  files.add("good.mesh", print_mesh(shapes::cube(), Format::Mesh));
  Recorder recorder;
  const SetAnalysis set = analyze_set(files.paths(), asking(true, true), recorder).value();
  EXPECT_EQ(Calls(recorder.calls.begin() + 4, recorder.calls.begin() + 8),
            (Calls{"trouble 2", "files 3/4 24", "mesh 3", "files 4/4 36"}));
  EXPECT_EQ(recorder.told.troubles.at(2).find(files.paths()[2] + ":1: "), 0U);
  EXPECT_EQ(set.meshes, 3U);
  EXPECT_EQ(set.unreadable, 1U);
  EXPECT_EQ(set.names.size(), 4U);
  // Cubes 0 and 3 are the same.
  EXPECT_FALSE(set.intersections.value().pairs.empty());
  EXPECT_FALSE(set.separation.has_value());
  EXPECT_EQ(set.separation_reason.find("every mesh must be good, and bad.mesh is not"), 0U);
}

TEST(AnalyzeSet, ForceSeparatesWhatCanBeRead) {
  SoupFiles files(row_of_cubes(2));
  files.add("bad.mesh", "Vertex 1 0 0\n");
  files.add("open.mesh",
            print_mesh(shapes::cube(1.0, {5, 0, 0}), Format::Mesh) + "Face 13 1 2 9\n");
  const SetAnalysis set = analyzed(files, forced(asking(false, true)));
  EXPECT_TRUE(set.separation.value().is_forced);
  EXPECT_EQ(set.separation.value().meshes.size(), 3U);
}

TEST(AnalyzeSet, MeshThatIsNotGoodForbidsSeparationAlone) {
  std::vector<Soup> soups = row_of_cubes(2);
  soups.push_back(shapes::open_cube());
  const SoupFiles files(soups);
  Recorder recorder;
  const SetAnalysis set = analyze_set(files.paths(), asking(true, true), recorder).value();
  EXPECT_TRUE(set.intersections.has_value());
  EXPECT_FALSE(set.separation.has_value());
  EXPECT_NE(set.separation_reason.find("12.mesh is not (not closed)"), std::string::npos);
  for (const auto& [owner, findings] : recorder.told.findings) {
    EXPECT_TRUE(findings.intersections.has_value());
    EXPECT_FALSE(findings.separation.has_value());
  }
}

TEST(AnalyzeSet, AttributesAloneAreEnoughForWhatIsBetween) {
  SetOptions options = asking(true, true);
  options.request.mesh.scope = Scope::AttributesOnly;
  std::vector<Soup> soups = row_of_cubes(3);
  const SetAnalysis good = analyzed(SoupFiles(soups), options);
  EXPECT_EQ(good.separation.value().all.count, 24U);
  EXPECT_FALSE(good.statistics.has_value());
  // Fitness is judged all the same, intersections within a mesh included.
  soups[1] = shapes::merged(soups[1], shapes::translated(soups[1], {0.5, 0.5, 0.5}));
  EXPECT_FALSE(analyzed(SoupFiles(soups), options).separation.has_value());
}

TEST(AnalyzeSet, EmptySetIsAnAnswer) {
  Recorder recorder;
  const SetAnalysis set = analyze_set({}, asking(true, true), recorder).value();
  EXPECT_TRUE(recorder.calls.empty());
  EXPECT_EQ(set.meshes, 0U);
  EXPECT_TRUE(set.intersections.value().pairs.empty());
  EXPECT_TRUE(set.separation.value().meshes.empty());
}

TEST(AnalyzeSet, SetOfOneHasNothingBetween) {
  const SetAnalysis set = analyzed(SoupFiles({shapes::cube()}), asking(true, true));
  EXPECT_TRUE(set.intersections.value().pairs.empty());
  ASSERT_EQ(set.separation.value().meshes.size(), 1U);
  EXPECT_EQ(set.separation.value().without_closest, 8U);
  EXPECT_EQ(set.separation.value().all.count, 0U);
}

TEST(AnalyzeSet, MeshesWithoutFacesAreLeftOutOfWhatIsBetween) {
  std::vector<Soup> soups = row_of_cubes(2);
  soups.insert(soups.begin(), shapes::make({{0.5, 0.5, 0.5}}, {}));
  const SoupFiles files(soups);
  Recorder recorder;
  const SetAnalysis set = analyze_set(files.paths(), forced(asking(true, true)), recorder).value();
  EXPECT_EQ(recorder.told.findings.size(), 2U);
  EXPECT_EQ(recorder.calls.back(), "between 2/2 24");
  EXPECT_EQ(set.separation.value().meshes.size(), 2U);
  EXPECT_EQ(set.separation.value().all.min, 1.0);
}

/// Does something when it is told a mesh.
class Meddler : public Recorder {
 public:
  Meddler(Index number, std::function<void()> what) : number_(number), what_(std::move(what)) {}
  void on_mesh(Index number, const Analysis& mesh) override {
    Recorder::on_mesh(number, mesh);
    if (number == number_) {
      what_();
    }
  }

 private:
  Index number_;
  std::function<void()> what_;
};

std::string trouble_of(const SoupFiles& files, const SetOptions& options, Meddler& meddler) {
  try {
    (void)analyze_set(files.paths(), options, meddler);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(AnalyzeSet, FileThatChangesMeanwhileIsAnError) {
  for (const bool separation : {false, true}) {
    const SoupFiles files(row_of_cubes(3));
    const std::string& path = files.paths()[1];
    Meddler meddler(2, [&] { write_mesh(shapes::cube(1.0, {-2.0625, 0, 0}), path); });
    EXPECT_EQ(trouble_of(files, asking(!separation, separation, 0), meddler),
              separation ? path + ": has changed while the set was being analysed" : "");
  }
}

TEST(AnalyzeSet, FilesAreReadOnceWhereMemoryAllows) {
  const SoupFiles files(row_of_cubes(3));
  const SetAnalysis whole = analyzed(files, asking(true, true));
  Meddler meddler(2, [&] {
    for (const std::string& path : files.paths()) std::remove(path.c_str());
  });
  const auto found = analyze_set(files.paths(), asking(true, true), meddler);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->separation);
  EXPECT_EQ(found->separation->all.count, 24U);
  EXPECT_EQ(found->separation->all.mean, whole.separation->all.mean);
  EXPECT_EQ(found->intersections->n_pairs(), 0U);
}

TEST(AnalyzeSet, FileThatGoesAwayMeanwhileIsAnError) {
  const SoupFiles files(row_of_cubes(3));
  const std::string& path = files.paths()[0];
  Meddler meddler(2, [&] { std::remove(path.c_str()); });
  EXPECT_EQ(trouble_of(files, asking(false, true, 0), meddler).find(path + ": "), 0U);
  // The findings before it in the order in space were reported.
  EXPECT_EQ(meddler.told.findings.count(2), 1U);
}

/// Wants to stop after so many calls.
class Impatient : public Recorder {
 public:
  explicit Impatient(std::size_t n) : n_(n) {}
  bool wants_to_stop() override { return n_calls_ >= n_; }

 protected:
  void call(const std::string& name, const std::string& said) override {
    Recorder::call(name, said);
    ++n_calls_;
  }

 private:
  std::size_t n_;
  std::atomic<std::size_t> n_calls_ = 0;
};

TEST(AnalyzeSet, StopsWhenTheListenerWantsIt) {
  const SoupFiles files(row_of_cubes(4));
  Recorder whole;
  (void)analyze_set(files.paths(), asking(true, true), whole);
  for (std::size_t n = 0; n + 1 < whole.calls.size(); ++n) {
    Impatient impatient(n);
    EXPECT_FALSE(analyze_set(files.paths(), asking(true, true), impatient).has_value());
    // A mesh or findings come with their progress.
    EXPECT_EQ(impatient.calls, Calls(whole.calls.begin(),
                                     whole.calls.begin() + static_cast<std::ptrdiff_t>(n + n % 2)));
  }
  Impatient patient(whole.calls.size() + 1);
  EXPECT_TRUE(analyze_set(files.paths(), asking(true, true), patient).has_value());
}

void expect_refused(const SetOptions& options) {
  Recorder recorder;
  EXPECT_THROW(static_cast<void>(analyze_set({}, options, recorder)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(analyze_files({}, options, recorder)), InvalidArgument);
}

TEST(AnalyzeSet, OptionsThatMakeNoSenseAreRefusedBeforeAnyFileIsRead) {
  SetOptions options = asking(true, true);
  for (const double no_length : test::kNoLengths) {
    options.request.between.separation = {.search_radius = no_length};
    expect_refused(options);
    options.request.between.separation = {.include_self = no_length};
    expect_refused(options);
    options.request.between.separation = {.search_cone_degrees = no_length};
    expect_refused(options);
  }
  options.request.between.separation = {.search_cone_degrees = 90.5};
  expect_refused(options);
}

TEST(AnalyzeSet, TimeLimitsAreNotNegative) {
  SetOptions options = asking(false, false);
  options.request.time_limit = kNaN;
  expect_refused(options);
  options.request.time_limit = -1.0;
  expect_refused(options);
  options.request.time_limit = kInfinity;
  Recorder recorder;
  EXPECT_TRUE(analyze_set({}, options, recorder));
}

TEST(AnalyzeSet, ShardThatDoesNotExistIsRefused) {
  SetOptions options = asking(false, false);
  for (const Shard& shard : {Shard{0, 0}, Shard{2, 2}, Shard{7, 3}}) {
    options.shard = shard;
    expect_refused(options);
  }
}

}  // namespace
}  // namespace meshalyzer
