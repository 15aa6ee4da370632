#include "meshalyzer/base/error.h"
#include "meshalyzer/report/json/report.h"
#include "sample_analysis.h"
#include "sample_set.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using nlohmann::json;

json parsed_set(const SetAnalysis& set) {
  return json::parse(json_report({}, &set, JsonOffenders::Omit))["set"];
}

/// A report into a text.
struct Written {
  std::string text;
  std::size_t longest_piece = 0;
  JsonReport report{[this](std::string_view piece) {
                      text += piece;
                      longest_piece = std::max(longest_piece, piece.size());
                    },
                    JsonOffenders::List};
};

TEST(JsonReportPieces, MakeTheSameTextAsAllAtOnce) {
  const SetAnalysis set = sample_set();
  const std::vector<Analysis> meshes(3, sample_analysis());
  Written written;
  for (const Analysis& mesh : meshes) {
    written.report.add(mesh);
  }
  written.report.finish(&set);
  EXPECT_EQ(written.text, json_report(meshes, &set, JsonOffenders::List));
}

TEST(JsonReportPieces, ReportOfNothingIsOne) {
  Written written;
  written.report.finish(nullptr);
  const json report = json::parse(written.text);
  EXPECT_EQ(report["meshes"], json::array());
  EXPECT_FALSE(report.contains("set"));
}

TEST(JsonReportPieces, ClosestPointsStandInTheSetAsTheyCome) {
  const SetAnalysis set = sample_set();
  Written written;
  written.report.add(sample_analysis());
  written.report.add(sample_findings(), set.names);
  ObjectFindings other = sample_findings();
  other.owner = 0;
  written.report.add(other, set.names);
  written.report.finish(&set);
  const json closest = json::parse(written.text)["set"]["closest"];
  const json rows =
      json::parse(R"([[20, -0.125, "c.off", 6, [1, 0.1, -0.0]], [-30, null, null, null, null]])");
  EXPECT_EQ(closest, (json{{"a.mesh", rows}, {"b.mesh", rows}}));
  EXPECT_LT(written.text.find("\"b.mesh\": [\n"), written.text.find("\"a.mesh\": [\n"));
}

TEST(JsonReportPieces, FindingsWithoutSeparationLeaveNoTrace) {
  const SetAnalysis set = sample_set();
  Written written;
  ObjectFindings findings = sample_findings();
  findings.separation.reset();
  written.report.add(findings, set.names);
  written.report.finish(&set);
  EXPECT_EQ(written.text, json_report({}, &set, JsonOffenders::List));
}

TEST(JsonReportPieces, LongListsAreNotKeptInMemory) {
  SetAnalysis set = sample_set();
  set.intersections->pairs.resize(100000);
  ObjectFindings findings = sample_findings();
  ObjectSeparation& rows = *findings.separation;
  rows.vertices.resize(100000);
  rows.distances.resize(100000);
  rows.objects.resize(100000);
  rows.faces.resize(100000);
  rows.points.resize(100000, Vec3::Zero());
  Written written;
  written.report.add(findings, set.names);
  written.report.finish(&set);
  EXPECT_GT(written.text.size(), 5'000'000U);
  EXPECT_LT(written.longest_piece, 100'000U);
  EXPECT_EQ(json::parse(written.text)["set"]["intersecting_pairs"].size(), 100000U);
}

TEST(JsonReportPieces, OrderOfThePiecesIsHeldTo) {
  const SetAnalysis set = sample_set();
  Written written;
  written.report.add(sample_findings(), set.names);
  EXPECT_THROW(written.report.add(sample_analysis()), InvalidArgument);
  EXPECT_THROW(written.report.add_unreadable("a.mesh", "away"), InvalidArgument);
  EXPECT_THROW(written.report.finish(nullptr), InvalidArgument);
  written.report.finish(&set);
  EXPECT_THROW(written.report.finish(&set), InvalidArgument);
  EXPECT_THROW(written.report.add(sample_findings(), set.names), InvalidArgument);
}

TEST(JsonReportOfSet, TotalsStandUnderTheirKeys) {
  const json shown = parsed_set(sample_set());
  EXPECT_EQ(shown["meshes"], 3);
  EXPECT_EQ(shown["unreadable"], 1);
  EXPECT_EQ(shown["good"], 2);
  EXPECT_EQ(shown["is_good"], false);
  EXPECT_EQ(shown["verdict"], json::parse(R"({"good": false, "reasons": [
      "1 mesh is not good", "1 file cannot be read", "5 pairs of faces of different meshes intersect",
      "1 mesh is inside another one", "2 meshes are partly inside another one"]})"));
  EXPECT_EQ(shown["vertices"], 10);
  EXPECT_EQ(shown["faces"], 11);
  EXPECT_EQ(shown["edges"], 12);
  EXPECT_EQ(shown["components"], 13);
  EXPECT_EQ(shown["boundaries"], 14);
  EXPECT_EQ(shown["intersecting_pairs_within"], 15);
  EXPECT_EQ(shown["area"], 2.5);
  EXPECT_EQ(shown["volume"], 1.5);
  EXPECT_EQ(shown["face_area"]["total"], 6);
  EXPECT_EQ(shown["edge_angle"]["count"], 0);
  EXPECT_EQ(shown["undefined"], (json{{"volume", "meshes without a volume: 1"}}));
  EXPECT_EQ(shown["not_good"], json::parse(R"([["b.mesh", ["not closed", "2 orphan vertices"]],
                                               ["torn.mesh", ["cannot be read: torn"]]])"));
}

TEST(JsonReportOfSet, IntersectionsAreRowsOfNamesAndFaceIds) {
  const json shown = parsed_set(sample_set());
  EXPECT_EQ(shown["intersecting_pair_count"], 5);
  EXPECT_EQ(shown["intersecting_pairs"][0],
            json::parse(R"(["a.mesh", 3, "b.mesh", 17, "crossing"])"));
  EXPECT_EQ(shown["intersecting_pairs"][4],
            json::parse(R"(["b.mesh", 5, "c.off", 6, "coplanar-overlap"])"));
  EXPECT_EQ(shown["contained"], json::parse(R"([["c.off", "a.mesh"]])"));
  EXPECT_EQ(shown["partly_contained"],
            json::parse(R"([["a.mesh", "c.off"], ["b.mesh", "c.off"]])"));
}

TEST(JsonReportOfSet, LowerBoundsAreToldBesideTheirNumbers) {
  SetAnalysis set = sample_set();
  const auto bounds_of = [](const json& shown) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : shown.items()) {
      if (key.ends_with("_at_least") && value == true) keys.push_back(key);
    }
    return keys;
  };
  EXPECT_EQ(bounds_of(parsed_set(set)), std::vector<std::string>());
  set.intersections->is_search_stopped = true;
  EXPECT_EQ(bounds_of(parsed_set(set)),
            (std::vector<std::string>{"contained_at_least", "intersecting_pairs_at_least"}));
  set.intersections.reset();
  set.is_search_within_stopped = true;
  EXPECT_EQ(bounds_of(parsed_set(set)),
            std::vector<std::string>{"intersecting_pairs_within_at_least"});
  set.is_measured = false;
  EXPECT_EQ(bounds_of(parsed_set(set)), std::vector<std::string>());
}

TEST(JsonReportOfSet, SeparationIsAStatisticAMeshAndOneOfAll) {
  SetAnalysis set = sample_set();
  set.separation->options.search_radius = 2.5;
  set.separation->options.include_self = 0.0;
  const json shown = parsed_set(set);
  EXPECT_EQ(shown["separation_all"]["count"], 5);
  EXPECT_EQ(shown["separation"].size(), 3U);
  EXPECT_EQ(shown["separation"]["a.mesh"]["min"], -1);
  EXPECT_EQ(shown["separation"]["b.mesh"]["mean"], 4);
  EXPECT_TRUE(shown["separation"]["c.off"]["mean"].is_null());
  EXPECT_EQ(shown["separation_inside"], json::parse(R"({"a.mesh": 1, "b.mesh": 0, "c.off": 0})"));
  EXPECT_EQ(shown["separation_without_closest"],
            json::parse(R"({"a.mesh": 0, "b.mesh": 4, "c.off": 6})"));
  EXPECT_EQ(shown["separation_inside_count"], 1);
  EXPECT_EQ(shown["separation_without_closest_count"], 10);
  EXPECT_EQ(shown["separation_forced"], false);
  EXPECT_EQ(
      shown["separation_options"],
      json::parse(R"({"search_radius": 2.5, "search_cone_degrees": null, "include_self": 0})"));
}

TEST(JsonReportOfSet, WhatWasNotAskedForIsNullAndKeepsItsKey) {
  const json full = parsed_set(sample_set());
  SetAnalysis set;
  set.is_measured = false;
  set.separation_reason = "b.mesh is not good";
  const json shown = parsed_set(set);
  for (const auto& [key, value] : full.items()) {
    EXPECT_TRUE(shown.contains(key)) << key;
  }
  for (const char* key : {"good",
                          "is_good",
                          "area",
                          "volume",
                          "intersecting_pairs_within",
                          "vertex_valence",
                          "edge_angle",
                          "intersecting_pairs",
                          "intersecting_pair_count",
                          "contained",
                          "partly_contained",
                          "closest",
                          "separation",
                          "separation_all",
                          "separation_options",
                          "separation_forced",
                          "separation_inside",
                          "separation_without_closest",
                          "separation_inside_count",
                          "separation_without_closest_count"}) {
    EXPECT_TRUE(shown[key].is_null()) << key;
  }
  EXPECT_EQ(shown["verdict"], json::parse(R"({"good": null, "reasons": []})"));
  EXPECT_EQ(shown["undefined"], (json{{"separation", "b.mesh is not good"}}));
}

TEST(JsonReportOfSet, InfiniteTotalsAreNullAndToldBeside) {
  SetAnalysis set;
  set.area = std::numeric_limits<double>::infinity();
  const json shown = parsed_set(set);
  EXPECT_TRUE(shown["area"].is_null());
  EXPECT_EQ(shown["non_finite"], (json{{"area", "inf"}}));
}

TEST(JsonReportOfSet, PairsHaveALineEach) {
  const SetAnalysis set = sample_set();
  const std::string text = json_report({}, &set, JsonOffenders::Omit);
  EXPECT_NE(text.find("\n   [\"a.mesh\", 3, \"b.mesh\", 17, \"crossing\"],\n"), std::string::npos);
}

TEST(JsonReportPieces, SinkThatIsNullIsRefused) {
  EXPECT_THROW(JsonReport(nullptr, JsonOffenders::Omit), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
