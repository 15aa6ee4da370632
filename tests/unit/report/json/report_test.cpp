#include "meshalyzer/report/json/report.h"

#include "sample_analysis.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using nlohmann::json;

json parsed(const Analysis& analysis, JsonOffenders offenders = JsonOffenders::Omit) {
  return json::parse(json_report({&analysis, 1}, nullptr, offenders));
}

json parsed_mesh(const Analysis& analysis, JsonOffenders offenders = JsonOffenders::Omit) {
  return parsed(analysis, offenders)["meshes"][0];
}

std::vector<std::string> keys_of(const json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) {
    keys.push_back(key);
  }
  return keys;
}

void expect_keys(const json& object, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    EXPECT_TRUE(object.contains(key)) << key;
  }
}

TEST(JsonReport, HasAllKeysThatProgramsRelyOn) {
  Analysis analysis;
  analysis.components.resize(1);
  const json report = parsed(analysis);
  EXPECT_EQ(report["schema"], "meshalyzer-report/1");
  EXPECT_TRUE(report["version"].is_string());
  const json& mesh = report["meshes"][0];
  expect_keys(mesh, {"path", "format", "good", "reasons"});
  expect_keys(mesh["integrity"], {"orphan_vertices", "missing_vertices", "degenerate_faces",
                                  "duplicate_vertex_indices", "duplicate_face_indices",
                                  "contiguous_vertices", "contiguous_faces"});
  EXPECT_EQ(
      keys_of(mesh["attributes"]),
      (std::vector<std::string>{"closed", "consistent", "manifold", "orientable", "outward"}));
  expect_keys(mesh["characteristics"], {"vertices",
                                        "faces",
                                        "edges",
                                        "components",
                                        "edge_components",
                                        "boundaries",
                                        "border_edges",
                                        "non_manifold_edges",
                                        "non_manifold_vertices",
                                        "pinched_vertices",
                                        "flipped_edges",
                                        "indistinguishable_vertices",
                                        "indistinguishable_edges",
                                        "zero_area_faces",
                                        "duplicate_faces",
                                        "intersecting_pairs",
                                        "unwelded_pairs",
                                        "intersecting_faces",
                                        "bounding_box",
                                        "area",
                                        "volume",
                                        "genus",
                                        "vertex_valence",
                                        "face_area",
                                        "aspect_ratio",
                                        "corner_angle",
                                        "edge_length",
                                        "edge_angle"});
  expect_keys(mesh["per_component"][0],
              {"faces", "vertices", "edges", "boundaries", "closed", "manifold", "consistent",
               "outward", "genus", "volume", "area", "inside"});
}

TEST(JsonReport, EachCountStandsUnderItsOwnKey) {
  Analysis analysis;
  Characteristics& c = analysis.characteristics;
  const std::array<std::size_t*, 18> fields{&c.vertices,
                                            &c.faces,
                                            &c.edges,
                                            &c.components,
                                            &c.edge_components,
                                            &c.boundaries,
                                            &c.border_edges,
                                            &c.non_manifold_edges,
                                            &c.non_manifold_vertices,
                                            &c.pinched_vertices,
                                            &c.flipped_edges,
                                            &c.indistinguishable_vertices,
                                            &c.indistinguishable_edges,
                                            &c.zero_area_faces,
                                            &c.duplicate_faces,
                                            &c.intersecting_pairs,
                                            &c.unwelded_pairs,
                                            &c.intersecting_faces};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    *fields[i] = i + 1;
  }
  const json shown = parsed_mesh(analysis)["characteristics"];
  const std::array<const char*, 18> keys{"vertices",
                                         "faces",
                                         "edges",
                                         "components",
                                         "edge_components",
                                         "boundaries",
                                         "border_edges",
                                         "non_manifold_edges",
                                         "non_manifold_vertices",
                                         "pinched_vertices",
                                         "flipped_edges",
                                         "indistinguishable_vertices",
                                         "indistinguishable_edges",
                                         "zero_area_faces",
                                         "duplicate_faces",
                                         "intersecting_pairs",
                                         "unwelded_pairs",
                                         "intersecting_faces"};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_EQ(shown[keys[i]], i + 1) << keys[i];
  }
}

TEST(JsonReport, AttributesAreTrueFalseOrNullWithTheReasonBeside) {
  Analysis analysis;
  analysis.attributes.closed.value = true;
  analysis.attributes.manifold.value = false;
  analysis.attributes.outward.reason = "the mesh is not manifold";
  const json mesh = parsed_mesh(analysis);
  EXPECT_EQ(mesh["attributes"]["closed"], true);
  EXPECT_EQ(mesh["attributes"]["manifold"], false);
  EXPECT_TRUE(mesh["attributes"]["outward"].is_null());
  EXPECT_EQ(mesh["undefined"], (json{{"outward", "the mesh is not manifold"}}));
}

TEST(JsonReport, StatisticsCarryTheirHistogram) {
  Analysis analysis;
  std::vector<double> values{1, 2, 3, std::numeric_limits<double>::infinity()};
  analysis.characteristics.aspect_ratio = summarize(values);
  const json shown = parsed_mesh(analysis)["characteristics"]["aspect_ratio"];
  EXPECT_EQ(shown["count"], 3);
  EXPECT_EQ(shown["infinite"], 1);
  EXPECT_EQ(shown["min"], 1);
  EXPECT_EQ(shown["max"], 3);
  EXPECT_EQ(shown["mean"], 2);
  EXPECT_EQ(shown["median"], 2);
  EXPECT_EQ(shown["variance"], 1);  // ((1-2)^2 + 0 + (3-2)^2) / 2
  EXPECT_EQ(shown["total"], 6);
  EXPECT_EQ(shown["histogram"]["edges"].size(), 17U);
  EXPECT_EQ(shown["histogram"]["counts"].size(), 16U);
}

TEST(JsonReport, StatisticsOfNothingAreNullButForTheirCount) {
  const json shown = parsed_mesh({})["characteristics"]["face_area"];
  EXPECT_EQ(shown["count"], 0);
  for (const char* key : {"min", "max", "mean", "median", "variance", "total", "histogram"}) {
    EXPECT_TRUE(shown[key].is_null()) << key;
  }
}

TEST(JsonReport, GenusIsNullWithOrphansAndThatOfTheComponentsStandsBeside) {
  Analysis analysis;
  analysis.characteristics.genus.reason = "2 orphan vertices";
  analysis.characteristics.genus_of_components = 5;
  const json shown = parsed_mesh(analysis)["characteristics"];
  EXPECT_TRUE(shown["genus"].is_null());
  EXPECT_EQ(shown["genus_of_components"], 5);
}

TEST(JsonReport, WhatOnlyAttributesLeaveOutIsNull) {
  Analysis analysis;
  analysis.has_characteristics = false;
  analysis.characteristics.vertices = 4;
  const json shown = parsed_mesh(analysis)["characteristics"];
  EXPECT_EQ(shown["vertices"], 4);
  EXPECT_TRUE(shown["intersecting_pairs"].is_null());
  EXPECT_TRUE(shown["area"].is_null());
  EXPECT_EQ(keys_of(shown), keys_of(parsed_mesh({})["characteristics"]));
}

TEST(JsonReport, TotalsOverMeshesOfOnlyAttributesAreNull) {
  SetAnalysis set;
  set.is_measured = false;
  set.vertices = 4;
  const json shown = json::parse(json_report({}, &set, JsonOffenders::Omit))["set"];
  EXPECT_TRUE(shown["area"].is_null());
  EXPECT_TRUE(shown["intersecting_pairs_within"].is_null());
  EXPECT_EQ(shown["vertices"], 4);
}

TEST(JsonReport, GoodIsNullUnlessAsked) {
  Analysis analysis;
  EXPECT_TRUE(parsed_mesh(analysis)["good"].is_null());
  EXPECT_EQ(parsed_mesh(analysis)["reasons"], json::array());
  analysis.goodness = Goodness{false, {"not closed", "2 orphan vertices"}};
  EXPECT_EQ(parsed_mesh(analysis)["good"], false);
  EXPECT_EQ(parsed_mesh(analysis)["reasons"], (json{"not closed", "2 orphan vertices"}));
}

TEST(JsonReport, OffendersAreOnlyListedWhenAsked) {
  EXPECT_FALSE(parsed_mesh(sample_analysis()).contains("offenders"));
}

TEST(JsonReport, OffendersAreNamedByFileId) {
  const json listed = parsed_mesh(sample_analysis(), JsonOffenders::List)["offenders"];
  EXPECT_EQ(listed["border_edges"], json::parse("[[10, 30, [7]], [20, 30, [7]]]"));
  EXPECT_EQ(listed["non_manifold_edges"], json::parse("[[10, 20, [7, 9]]]"));
  EXPECT_EQ(listed["flipped_edges"], json::array());
  EXPECT_EQ(listed["non_manifold_vertices"], json{40});
  EXPECT_EQ(listed["intersecting_pairs"], json::parse(R"([[7, 9, "crossing"]])"));
  EXPECT_EQ(listed["missing_vertices"], json{99});
  EXPECT_EQ(listed["orphan_vertices"], (json{30, 40}));
  EXPECT_EQ(listed["degenerate_faces"], json{9});
  EXPECT_EQ(listed["vertex_numbering"], json::parse(R"({"ids": [10, 20, 30], "offender": 0})"));
  EXPECT_TRUE(listed["face_numbering"].is_null());
  EXPECT_FALSE(listed.contains("short_edges"));
}

TEST(JsonReport, ListsAskedForByThresholdCarryTheirValues) {
  Analysis analysis = sample_analysis();
  analysis.offenders.short_edges = EdgeList{{{0, 1}}, {0, 2}, {0, 1}, {0.25}};
  analysis.offenders.large_aspect_ratios = FaceList{{1}, {17.5}};
  const json listed = parsed_mesh(analysis)["offenders"];
  EXPECT_EQ(listed["short_edges"], json::parse("[[10, 20, [7, 9], 0.25]]"));
  EXPECT_EQ(listed["large_aspect_ratios"], json::parse("[[9, 17.5]]"));
  EXPECT_FALSE(listed.contains("border_edges"));
}

TEST(JsonReport, ListsThatNobodyComputedHaveNoKey) {
  Analysis analysis = sample_analysis();
  analysis.has_characteristics = false;
  const json listed = parsed_mesh(analysis, JsonOffenders::List)["offenders"];
  EXPECT_TRUE(listed.contains("border_edges"));
  EXPECT_FALSE(listed.contains("intersecting_pairs"));
}

TEST(JsonReport, ComponentsNameTheirFirstFaceAndTheOneAroundThem) {
  Analysis analysis = sample_analysis();
  analysis.components.resize(2);
  analysis.components[1].first_face = 1;
  analysis.components[1].inside = 0;
  analysis.component_statistics.resize(2);
  analysis.component_statistics[1].face_area.count = 1;
  analysis.component_statistics[1].face_area.max = 2.5;
  const json shown = parsed_mesh(analysis)["per_component"];
  EXPECT_TRUE(shown[0]["inside"].is_null());
  EXPECT_EQ(shown[1]["inside"], 0);
  EXPECT_EQ(shown[1]["first_face"], 9);
  EXPECT_EQ(shown[1]["face_area"]["max"], 2.5);
  EXPECT_TRUE(shown[0]["face_area"]["max"].is_null());
}

TEST(JsonReport, SetStandsBesideTheMeshesOfAFolder) {
  SetAnalysis set;
  set.meshes = 2;
  set.unreadable = 1;
  set.area = 3.5;
  set.volume.value = -1.25;
  const std::vector<Analysis> meshes(2);
  const json report = json::parse(json_report(meshes, &set, JsonOffenders::Omit));
  EXPECT_EQ(report["meshes"].size(), 2U);
  EXPECT_EQ(report["set"]["meshes"], 2);
  EXPECT_EQ(report["set"]["unreadable"], 1);
  EXPECT_EQ(report["set"]["area"], 3.5);
  EXPECT_EQ(report["set"]["volume"], -1.25);
  EXPECT_TRUE(report["set"]["separation"].is_null());
  EXPECT_FALSE(parsed(Analysis{}).contains("set"));
}

TEST(JsonReport, PathThatIsNotUnicodeLeavesAReadableReport) {
  Analysis analysis;
  analysis.path = "caf\xE9.mesh";
  EXPECT_EQ(parsed_mesh(analysis)["path"], "caf\xEF\xBF\xBD.mesh");
}

}  // namespace
}  // namespace meshalyzer
