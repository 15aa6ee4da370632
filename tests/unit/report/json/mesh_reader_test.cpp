#include "meshalyzer/base/error.h"
#include "meshalyzer/report/json/mesh.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/json/writer.h"
#include "meshalyzer/report/text/mesh_report.h"
#include "sample_analysis.h"
#include "support/constants.h"
#include "support/effort.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using nlohmann::json;

std::string line_of(const Analysis& analysis, JsonOffenders offenders = JsonOffenders::List) {
  JsonWriter writer;
  writer.begin_object(JsonLayout::Row);
  write_mesh_members(writer, analysis, offenders);
  writer.end_object();
  return writer.take();
}

Statistics statistics_of(std::vector<double> values) {
  return summarize(values);
}

/// The sample with a value in every member, no two alike where that can be seen.
Analysis full_analysis() {
  Analysis a = sample_analysis();
  a.format = Format::Stl;
  a.n_merged_points = 3;
  a.n_polygons = 4;
  a.integrity = {11, 12, 13, 14, 15, 2, false, true};
  a.attributes = {{true, ""}, {false, ""}, {{}, "the first"}, {{}, "the second"}, {{}, "third"}};
  a.characteristics.vertices = 21;
  a.characteristics.duplicate_faces = 22;
  a.characteristics.intersecting_pairs = 23;
  a.characteristics.bounding_box = Box3(Vec3(-0.0, 0.1, -1.5), Vec3(0.0, 1e-300, 2));
  a.characteristics.area = 1.0 / 3.0;
  a.characteristics.volume.reason = "the volume";
  a.characteristics.genus.reason = "the genus";
  a.characteristics.genus_of_components = -6;
  a.characteristics.edge_length = statistics_of({0.1, 0.2, kInfinity});
  a.curvature = CurvatureStatistics{VertexArea::Voronoi,
                                    statistics_of({-1.5, 0.1}),
                                    statistics_of({0.1, 0.7}),
                                    statistics_of({2, 3, kInfinity}),
                                    statistics_of({-7, -0.25}),
                                    {31, 32, 33, 34, 35},
                                    0.1 + 0.2};
  a.components.resize(2);
  a.components[0].first_face = 1;
  a.components[1].first_face = 0;
  a.components[1].closed = true;
  a.components[1].consistent = false;
  a.components[1].inside = 0;
  a.components[1].volume = -0.25;
  a.components[1].area = kInfinity;
  a.component_statistics.resize(2);
  a.component_statistics[1].edge_angle = statistics_of({30, 60});
  a.offenders.torn_lines = {70, 80};
  a.offenders.face_numbering = NumberingBreak{{1, 3}, 1};
  a.offenders.duplicate_face_records = {1};
  a.offenders.indistinguishable_vertices = {3, 1};
  a.offenders.small_angles = EdgeList{{{1, 2}}, {0, 1}, {1}, {12.5}};
  a.offenders.long_edges = EdgeList{{{0, 3}}, {0, 1}, {0}, {kInfinity}};
  a.offenders.short_edges = EdgeList{};
  a.offenders.large_aspect_ratios = FaceList{{0, 1}, {3.5, kInfinity}};
  a.fitness = judge_fitness(a);
  return a;
}

void expect_same_reports(const Analysis& read, const Analysis& written) {
  EXPECT_EQ(line_of(read), line_of(written));
  EXPECT_EQ(line_of(read, JsonOffenders::Omit), line_of(written, JsonOffenders::Omit));
  EXPECT_EQ(text_report(read, OffenderStyle::Ids), text_report(written, OffenderStyle::Ids));
  EXPECT_EQ(text_report(read, OffenderStyle::None), text_report(written, OffenderStyle::None));
}

void expect_verdict(const std::optional<Goodness>& verdict, const Goodness& expected) {
  ASSERT_TRUE(verdict.has_value());
  EXPECT_EQ(verdict->good, expected.good);
  EXPECT_EQ(verdict->reasons, expected.reasons);
}

std::string message_of(const std::string& text) {
  try {
    static_cast<void>(read_mesh_members(text));
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(ReadMeshMembers, EveryMemberComesBackInTheReports) {
  expect_same_reports(read_mesh_members(line_of(full_analysis())), full_analysis());
}

TEST(ReadMeshMembers, MeshOfAReportReadsLikeALine) {
  const std::vector<Analysis> meshes{full_analysis()};
  const std::string report = json_report(meshes, nullptr, JsonOffenders::List);
  const std::size_t begin = report.find('{', 1);
  const std::size_t end = report.rfind(']');
  expect_same_reports(read_mesh_members(report.substr(begin, end - begin)), full_analysis());
}

TEST(ReadMeshMembers, MembersThatAreNoneOfAMeshDoNotMatter) {
  json line = json::parse(line_of(full_analysis()));
  line["number"] = 5;
  line["stamp"] = json::parse(R"({"path": 1, "integrity": [[], {}]})");
  expect_same_reports(read_mesh_members(line.dump()), full_analysis());
}

TEST(ReadMeshMembers, WithoutOffendersTheBreaksOfTheFileAreStillTold) {
  const Analysis written = full_analysis();
  const Analysis read = read_mesh_members(line_of(written, JsonOffenders::Omit));
  EXPECT_EQ(text_report(read, OffenderStyle::None), text_report(written, OffenderStyle::None));
  EXPECT_EQ(line_of(read, JsonOffenders::Omit), line_of(written, JsonOffenders::Omit));
}

TEST(ReadMeshMembers, OnlyAttributesStayOnlyAttributes) {
  Analysis written = full_analysis();
  written.has_characteristics = false;
  const Analysis read = read_mesh_members(line_of(written));
  EXPECT_FALSE(read.has_characteristics);
  expect_same_reports(read, written);
}

TEST(ReadMeshMembers, VerdictsComeBackWithTheirReasons) {
  Analysis written = full_analysis();
  written.goodness = Goodness{false, {"one", "two"}};
  expect_verdict(read_mesh_members(line_of(written)).goodness, *written.goodness);
  written.goodness = Goodness{true, {}};
  expect_verdict(read_mesh_members(line_of(written)).goodness, *written.goodness);
  written.goodness.reset();
  EXPECT_FALSE(read_mesh_members(line_of(written)).goodness.has_value());
}

TEST(ReadMeshMembers, FitnessOfOnlyAttributesComesBackWhereItWasJudged) {
  Analysis written = sample_analysis();
  written.has_characteristics = false;
  written.fitness.reset();
  EXPECT_FALSE(read_mesh_members(line_of(written)).fitness.has_value());
  written.fitness = Goodness{false, {"not closed"}};
  expect_verdict(read_mesh_members(line_of(written)).fitness, *written.fitness);
}

TEST(ReadMeshMembers, FitnessFollowsFromTheCharacteristics) {
  Analysis written;
  written.attributes = {{true, ""}, {true, ""}, {true, ""}, {true, ""}, {true, ""}};
  expect_verdict(read_mesh_members(line_of(written)).fitness, {true, {}});
  written.characteristics.intersecting_pairs = 2;
  expect_verdict(read_mesh_members(line_of(written)).fitness,
                 {false, {"intersecting pairs of faces: 2"}});
}

TEST(ReadMeshMembers, PathThatIsNotUnicodeComesBackByteByByte) {
  Analysis written = sample_analysis();
  written.path = "caf\xE9/\xC3\xA9\n\".mesh";
  EXPECT_EQ(read_mesh_members(line_of(written)).path, written.path);
  written.path = "caf\xC3\xA9.mesh";
  EXPECT_EQ(read_mesh_members(line_of(written)).path, written.path);
  EXPECT_FALSE(json::parse(line_of(written)).contains("path_bytes"));
}

TEST(ReadMeshMembers, MeasuresBeyondADoubleComeBack) {
  Analysis written;
  written.characteristics.area = kInfinity;
  written.characteristics.volume.value = -kInfinity;
  const Analysis read = read_mesh_members(line_of(written));
  EXPECT_EQ(read.characteristics.area, kInfinity);
  EXPECT_EQ(read.characteristics.volume.value, -kInfinity);
}

TEST(ReadMeshMembers, IdsThatOccurMakeSmallAscendingTables) {
  Analysis written = sample_analysis();
  written.vertex_ids.named = {40, 30, 20, -10};
  const Analysis read = read_mesh_members(line_of(written));
  EXPECT_EQ(read.vertex_ids.named, (std::vector<std::int32_t>{-10, 20, 30, 40}));
  EXPECT_EQ(read.face_ids.named, (std::vector<std::int32_t>{7, 9}));
  EXPECT_EQ(read.offenders.orphan_vertices, (std::vector<Index>{1, 0}));  // 20, -10 as in the file
  expect_same_reports(read, written);
}

TEST(ReadMeshMembers, IdsBeyondThirtyTwoBitsAreRefused) {
  json line = json::parse(line_of(sample_analysis()));
  line["offenders"]["orphan_vertices"] = json::parse("[1, 2147483647, -2147483648]");
  EXPECT_EQ(read_mesh_members(line.dump()).offenders.orphan_vertices.size(), 3U);
  line["offenders"]["orphan_vertices"] = json::parse("[1, 2147483648]");
  EXPECT_THAT(message_of(line.dump()), testing::StartsWith("offenders.orphan_vertices[1]: "));
}

TEST(ReadMeshMembers, ElementOfTooFewOrTooManyPartsIsRefused) {
  const json line = json::parse(line_of(full_analysis()));
  for (const char* list : {"border_edges", "intersecting_pairs", "long_edges", "small_angles",
                           "large_aspect_ratios"}) {
    json longer = line;
    longer["offenders"][list][0].push_back(1);
    EXPECT_THAT(message_of(longer.dump()), testing::HasSubstr("too long")) << list;
    json shorter = line;
    shorter["offenders"][list][0].erase(shorter["offenders"][list][0].size() - 1);
    EXPECT_THAT(message_of(shorter.dump()), testing::HasSubstr("too short")) << list;
  }
}

TEST(ReadMeshMembers, LineCutOffAnywhereIsRefused) {
  const std::string line = line_of(full_analysis());
  for (std::size_t length = 0; length + 2 < line.size(); ++length) {
    EXPECT_NE(message_of(line.substr(0, length)), "nothing thrown") << length;
  }
}

/// All places in a JSON value, as pointers.
std::vector<json::json_pointer> places_of(const json& value) {
  std::vector<json::json_pointer> places;
  const json leaves = value.flatten();
  for (const auto& [key, leaf] : leaves.items()) {
    for (json::json_pointer place(key); !place.empty(); place.pop_back()) {
      places.push_back(place);
    }
  }
  return places;
}

TEST(ReadMeshMembers, AnyOtherKindOfValueAnywhereIsRefusedOrShown) {
  const json line = json::parse(line_of(full_analysis()));
  test::Effort effort;
  for (const auto& place : places_of(line)) {
    for (const char* other : {"null", "true", "-1", "3000000000", "0.5", "\"x\"", "[]", "{}"}) {
      if (!effort.runs_next()) {
        continue;
      }
      json changed = line;
      changed[place] = json::parse(other);
      try {
        const Analysis read = read_mesh_members(changed.dump());
        EXPECT_FALSE(text_report(read, OffenderStyle::Ids).empty());
      } catch (const InvalidArgument&) {
        SUCCEED();
      }
    }
  }
}

TEST(ReadMeshMembers, MemberThatIsMissingIsNamed) {
  Analysis written = full_analysis();
  written.goodness = Goodness{true, {}};
  const json line = json::parse(line_of(written));
  // These stand there only where there is something to say; the verdict follows from the rest.
  const std::set<std::string> optional{"/verdict",
                                       "/named_format",
                                       "/offenders",
                                       "/integrity/first_torn_line",
                                       "/integrity/vertex_numbering",
                                       "/integrity/face_numbering",
                                       "/per_component/1/vertex_valence",
                                       "/characteristics/curvature"};
  for (const std::string object : {"", "/integrity", "/attributes", "/characteristics",
                                   "/per_component/1", "/characteristics/edge_length"}) {
    for (const auto& [key, value] : line[json::json_pointer(object)].items()) {
      json changed = line;
      changed[json::json_pointer(object)].erase(key);
      if (optional.count(object + '/' + key) == 0) {
        // Without it the infinite area is unexplained.
        const std::string named = key == "non_finite" ? "area" : key;
        EXPECT_THAT(message_of(changed.dump()), testing::HasSubstr(named)) << object;
      }
    }
  }
}

TEST(ReadMeshMembers, TornLinesNeedTheirFirst) {
  json line = json::parse(line_of(full_analysis(), JsonOffenders::Omit));
  line["integrity"].erase("first_torn_line");
  EXPECT_THAT(message_of(line.dump()), testing::HasSubstr("first_torn_line"));
}

TEST(ReadMeshMembers, UnknownFormatAndContactAreRefused) {
  json line = json::parse(line_of(full_analysis()));
  line["format"] = "vrml";
  EXPECT_THAT(message_of(line.dump()), testing::StartsWith("format: "));
  line = json::parse(line_of(full_analysis()));
  line["offenders"]["intersecting_pairs"][0][2] = "kissing";
  EXPECT_THAT(message_of(line.dump()), testing::StartsWith("offenders.intersecting_pairs[0][2]: "));
}

}  // namespace
}  // namespace meshalyzer
