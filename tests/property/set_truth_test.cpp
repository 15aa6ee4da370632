#include "meshalyzer/base/parallel.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/io/write.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/set/set_run.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "support/described_set.h"
#include "support/packed_sets.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const std::string kMeshes = MESHALYZER_MESHES;
const std::string kCorpusSet = std::string(MESHALYZER_CORPUS) + "/neuropil_set";

/// The mesh files of a folder, in name order.
std::vector<std::string> files_of(const std::string& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Keeps the findings.
class Finder : public RunListener {
 public:
  std::vector<ObjectFindings> findings;
  std::string text;
  void on_mesh(Index, const Analysis& mesh) override { text += test::described(mesh); }
  void on_findings(const ObjectFindings& found) override {
    findings.push_back(found);
    text += test::described(found);
  }
};

struct Result {
  SetAnalysis set;
  std::vector<ObjectFindings> findings;
  std::string text;
};

Result analyzed(const std::vector<std::string>& files, const SetOptions& options) {
  Finder finder;
  SetAnalysis set = analyze_set(files, options, finder).value();
  const std::string text = finder.text + test::described(set);
  return {std::move(set), std::move(finder.findings), text};
}

/// The same bits for any number of threads, and however little memory there is.
Result analyzed_anyhow(const std::vector<std::string>& files) {
  Result result = analyzed(files, test::asking_all());
  for (const std::size_t n_threads : {1U, 2U}) {
    const ThreadLimit limit(n_threads);
    SetOptions options = test::asking_all();
    EXPECT_TRUE(analyzed(files, options).text == result.text) << n_threads << " threads";
    options.memory_limit = 0;
    EXPECT_TRUE(analyzed(files, options).text == result.text) << n_threads << " threads, no memory";
  }
  return result;
}

json expected_sets() {
  std::ifstream in(kMeshes + "/expected_sets.json");
  return json::parse(in);
}

json pairs_as_json(const SetAnalysis& set) {
  json all = json::array();
  for (const SetPair& pair : set.intersections->pairs) {
    all.push_back({set.names[pair.mesh_a], pair.face_a, set.names[pair.mesh_b], pair.face_b,
                   contact_name(pair.kind)});
  }
  return all;
}

json contained_as_json(const SetAnalysis& set) {
  json all = json::array();
  for (const ContainedMesh& mesh : set.intersections->contained) {
    all.push_back({set.names[mesh.inner], set.names[mesh.outer]});
  }
  return all;
}

/// @param expected  [vertex id, distance] of those vertices that are told of.
void expect_distances(const json& expected, const ObjectSeparation& separation) {
  for (const json& known : expected) {
    const auto place = std::find(separation.vertices.begin(), separation.vertices.end(),
                                 known.at(0).get<std::int64_t>());
    ASSERT_NE(place, separation.vertices.end());
    const double truth = known.at(1).get<double>();
    EXPECT_NEAR(separation.distances[static_cast<std::size_t>(place - separation.vertices.begin())],
                truth, 1e-12 * std::abs(truth))
        << "vertex " << known.at(0);
  }
}

TEST(SetTruth, WhatIsBetweenOurMeshesIsWhatTheRationalsSay) {
  const json sets = expected_sets();
  for (const auto& [folder, expected] : sets.items()) {
    SCOPED_TRACE(folder);
    const Result result = analyzed_anyhow(files_of(kMeshes + "/" + folder));
    EXPECT_EQ(pairs_as_json(result.set), expected.at("intersecting_pairs"));
    EXPECT_EQ(contained_as_json(result.set), expected.at("contained"));
    EXPECT_EQ(result.set.meshes, expected.at("meshes"));
    EXPECT_EQ(result.set.faces, expected.at("faces"));
    EXPECT_EQ(result.set.vertices, expected.at("vertices"));
    const double area = expected.at("area").get<double>();
    EXPECT_NEAR(result.set.area, area, 1e-14 * area);
    const double volume = expected.at("volume").get<double>();
    EXPECT_NEAR(result.set.volume.value.value(), volume, 1e-13 * volume);
    const json& separation = expected.at("separation");
    EXPECT_EQ(separation.size(), result.findings.size());
    for (const ObjectFindings& findings : result.findings) {
      const std::string& name = result.set.names[findings.owner];
      SCOPED_TRACE(name);
      EXPECT_EQ(separation.at(name).size(), findings.separation.value().vertices.size());
      expect_distances(separation.at(name), *findings.separation);
    }
  }
}

TEST(SetTruth, OwnSurfaceAcrossASlotIsAsFarAsTheSlotIsWide) {
  // The edges are 1 and sqrt(2) long, and the way to the other wall round the back of the slot at
  // least 3: faces near along the surface are left out, those across are not.
  const json folds = expected_sets().at("fold").at("folds");
  for (const double length : {1.0, 1.5}) {
    SetOptions options = test::asking_all();
    options.request.between.separation->include_self = length;
    const Result result = analyzed(files_of(kMeshes + "/fold"), options);
    std::size_t n_checked = 0;
    for (const ObjectFindings& findings : result.findings) {
      const std::string& name = result.set.names[findings.owner];
      if (folds.contains(name)) {
        expect_distances(folds.at(name), findings.separation.value());
        ++n_checked;
      }
    }
    EXPECT_EQ(n_checked, folds.size());
  }
}

/// All pairs of faces of different objects, found as intersections within the soup of all.
std::vector<SetPair> pairs_by_one_soup(const std::vector<Soup>& objects) {
  Soup all;
  std::vector<std::pair<Index, Index>> origin;
  for (Index object = 0; object < objects.size(); ++object) {
    for (Index face = 0; face < objects[object].n_faces(); ++face) {
      origin.emplace_back(object, face);
    }
    all = shapes::merged(std::move(all), objects[object]);
  }
  const CutMesh cut = build(all);
  std::vector<SetPair> pairs;
  for (const IntersectingPair& pair : find_self_intersections(cut, FaceTree(cut))) {
    const auto [a, face_a] = origin[pair.face_a];
    const auto [b, face_b] = origin[pair.face_b];
    if (a != b) {
      pairs.push_back(
          {a, objects[a].face_ids.of(face_a), b, objects[b].face_ids.of(face_b), pair.kind});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const SetPair& p, const SetPair& q) {
    return std::tuple(p.mesh_a, p.mesh_b, p.face_a, p.face_b) <
           std::tuple(q.mesh_a, q.mesh_b, q.face_a, q.face_b);
  });
  return pairs;
}

/// The kinds differ where vertices at one place would count as one in the soup: what crosses does
/// not.
void expect_same_pairs(const std::vector<SetPair>& found, const std::vector<SetPair>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const SetPair& p = found[i];
    const SetPair& q = expected[i];
    EXPECT_EQ(std::tuple(p.mesh_a, p.face_a, p.mesh_b, p.face_b),
              std::tuple(q.mesh_a, q.face_a, q.mesh_b, q.face_b));
    EXPECT_EQ(p.kind == ContactKind::Crossing, q.kind == ContactKind::Crossing);
  }
}

std::size_t expect_as_in_one_soup(const std::vector<std::string>& files) {
  std::vector<Soup> objects;
  std::transform(files.begin(), files.end(), std::back_inserter(objects), read_mesh);
  const Result result = analyzed_anyhow(files);
  expect_same_pairs(result.set.intersections->pairs, pairs_by_one_soup(objects));
  return result.set.intersections->pairs.size();
}

TEST(SetTruth, PairsBetweenOurMeshesAreThoseWithinOneSoupOfThem) {
  const json sets = expected_sets();
  std::size_t n_pairs = 0;
  for (const auto& [folder, expected] : sets.items()) {
    SCOPED_TRACE(folder);
    n_pairs += expect_as_in_one_soup(files_of(kMeshes + "/" + folder));
  }
  EXPECT_GT(n_pairs, 100U);
}

TEST(SetTruth, PairsBetweenRealMeshesAreThoseWithinOneSoupOfThem) {
  if (!fs::is_directory(kCorpusSet)) GTEST_SKIP() << "no corpus at " << kCorpusSet;
  const std::vector<std::string> files = files_of(kCorpusSet);
  EXPECT_EQ(files.size(), 7U);
  expect_as_in_one_soup(files);
}

TEST(SetTruth, PairsBetweenManyMeshesAreThoseWithinOneSoupOfThem) {
  const test::PackedSet set = test::pack_blobs({.n_objects = 60,
                                                .faces_per_object = 300,
                                                .gap = 0.125,
                                                .n_crossing = 8,
                                                .n_touching = 4,
                                                .n_contained = 3});
  const TemporaryFolder folder;
  std::vector<std::string> files;
  for (std::size_t i = 0; i < set.objects.size(); ++i) {
    files.push_back(folder.file(set.names[i]));
    write_mesh(set.objects[i], files.back());
  }
  EXPECT_GT(expect_as_in_one_soup(files), 20U);
}

}  // namespace
}  // namespace meshalyzer
