#include "meshalyzer/report/journal/line.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/report/json/mesh.h"
#include "meshalyzer/report/json/report.h"
#include "sample_analysis.h"
#include "sample_set.h"
#include "support/constants.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

const std::vector<std::string>& sample_names() {
  static const std::vector<std::string> names = sample_set().names;
  return names;
}

Request sample_request() {
  Request request;
  request.is_set = true;
  request.between.separation = SeparationOptions{.search_radius = 0.1};
  return request;
}

LineHead sample_head(LineHead::Kind kind) {
  return {.kind = kind,
          .number = 1,
          .of = 4,
          .path = "folder/b \"b\"\n.mesh",
          .stamp = {std::uint64_t{1} << 40U, -1'234'567'890'123'456'789},
          .request = sample_request(),
          .set = "0123456789abcdef"};
}

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

/// Bit for bit; NaN where nothing was found, whatever its bits.
void expect_same(const ObjectSeparation& read, const ObjectSeparation& written) {
  EXPECT_EQ(read.vertices, written.vertices);
  EXPECT_EQ(read.objects, written.objects);
  EXPECT_EQ(read.faces, written.faces);
  ASSERT_EQ(read.distances.size(), written.distances.size());
  ASSERT_EQ(read.points.size(), written.points.size());
  for (std::size_t i = 0; i < written.distances.size(); ++i) {
    if (written.objects[i] == kNoIndex) {
      EXPECT_TRUE(std::isnan(read.distances[i]));
    } else {
      EXPECT_EQ(bits(read.distances[i]), bits(written.distances[i]));
    }
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(bits(read.points[i][axis]), bits(written.points[i][axis]));
    }
  }
}

void expect_same(const ObjectFindings& read, const ObjectFindings& written) {
  EXPECT_EQ(read.owner, written.owner);
  ASSERT_EQ(read.intersections.has_value(), written.intersections.has_value());
  if (written.intersections) {
    EXPECT_EQ(read.intersections->pairs, written.intersections->pairs);
    EXPECT_EQ(read.intersections->contained, written.intersections->contained);
    EXPECT_EQ(read.intersections->partly_contained, written.intersections->partly_contained);
  }
  ASSERT_EQ(read.separation.has_value(), written.separation.has_value());
  if (written.separation) {
    expect_same(*read.separation, *written.separation);
  }
}

void expect_kept(const ObjectFindings& findings, const std::vector<std::string>& names) {
  LineHead head = sample_head(LineHead::Kind::Between);
  head.number = findings.owner;
  const std::string line = between_line(head, findings, names);
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  EXPECT_EQ(read_head(line), head);
  expect_same(read_between(line, names), findings);
}

/// Any finite double, or an infinite one.
double random_real(std::mt19937_64& random) {
  double value = std::bit_cast<double>(random());
  return std::isnan(value) ? kInfinity : value;
}

Index random_mesh(std::mt19937_64& random) {
  return static_cast<Index>(random() % sample_names().size());
}

SetIntersections random_intersections(std::mt19937_64& random) {
  SetIntersections found;
  for (std::size_t i = random() % 5; i > 0; --i) {
    found.pairs.push_back({random_mesh(random), static_cast<std::int32_t>(random()),
                           random_mesh(random), static_cast<std::int32_t>(random()),
                           static_cast<ContactKind>(random() % 6)});
  }
  for (std::vector<ContainedMesh>* list : {&found.contained, &found.partly_contained}) {
    for (std::size_t i = random() % 3; i > 0; --i) {
      list->push_back({random_mesh(random), random_mesh(random)});
    }
  }
  return found;
}

ObjectSeparation random_separation(std::mt19937_64& random) {
  ObjectSeparation separation;
  for (std::size_t i = random() % 20; i > 0; --i) {
    const bool is_found = random() % 4 != 0;
    separation.vertices.push_back(static_cast<std::int32_t>(random()));
    separation.distances.push_back(is_found ? random_real(random)
                                            : std::numeric_limits<double>::quiet_NaN());
    separation.objects.push_back(is_found ? random_mesh(random) : kNoIndex);
    separation.faces.push_back(is_found ? static_cast<std::int32_t>(random()) : 0);
    separation.points.push_back(
        is_found ? Vec3(random_real(random), random_real(random), random_real(random))
                 : Vec3(Vec3::Zero()));
  }
  return separation;
}

TEST(MeshLine, KeepsHeadAndMesh) {
  const Analysis analysis = sample_analysis();
  LineHead head = sample_head(LineHead::Kind::Mesh);
  const std::string line = mesh_line(head, analysis, JsonOffenders::List);
  head.path = analysis.path;
  EXPECT_EQ(read_head(line), head);
  const auto report = [](const Analysis& mesh) {
    return json_report({&mesh, 1}, nullptr, JsonOffenders::List);
  };
  EXPECT_EQ(report(read_mesh_members(line)), report(analysis));
}

TEST(MeshLine, IsOneObjectOnOneLine) {
  const std::string line =
      mesh_line(sample_head(LineHead::Kind::Mesh), sample_analysis(), JsonOffenders::List);
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  const auto object = nlohmann::json::parse(line);
  EXPECT_EQ(object["kind"], "mesh");
  EXPECT_EQ(object["number"], 1);
  EXPECT_EQ(object["offenders"]["missing_vertices"], nlohmann::json{99});
}

TEST(ReadHead, ReadsNoMoreThanTheHead) {
  const std::string line =
      mesh_line(sample_head(LineHead::Kind::Mesh), sample_analysis(), JsonOffenders::List);
  const std::size_t end = line.find("\"format\"") + std::string("\"format\"").size();
  EXPECT_EQ(read_head(line.substr(0, end)), read_head(line));
}

TEST(ReadHead, HeadThatIsCutOffIsRefused) {
  const std::string line = unreadable_line(sample_head(LineHead::Kind::Unreadable), "why");
  for (std::size_t length = 0; length <= line.find("error\""); ++length) {
    EXPECT_THROW(static_cast<void>(read_head(line.substr(0, length))), InvalidArgument) << length;
  }
}

TEST(ReadHead, WhatIsNoHeadIsRefused) {
  for (const char* text : {"[]", "{}", "7", "", "{\"number\": {}}", "{\"path\": \"a\"}"}) {
    EXPECT_THROW(static_cast<void>(read_head(text)), InvalidArgument) << text;
  }
}

TEST(ReadHead, WrongMembersAreRefused) {
  const std::string line = unreadable_line(sample_head(LineHead::Kind::Unreadable), "why");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = line;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_THROW(static_cast<void>(read_head(changed("\"number\": 1", "\"number\": -1"))),
               InvalidArgument);
  EXPECT_THROW(static_cast<void>(read_head(changed("\"number\": 1", "\"number\": 1.5"))),
               InvalidArgument);
  EXPECT_THROW(static_cast<void>(read_head(changed("\"of\"", "\"off\""))), InvalidArgument);
  EXPECT_THROW(static_cast<void>(read_head(changed("\"unreadable\"", "\"broken\""))),
               InvalidArgument);
}

TEST(UnreadableLine, KeepsThePathAndTheReasonWhateverTheirBytes) {
  LineHead head = sample_head(LineHead::Kind::Unreadable);
  head.path = "caf\xE9.mesh";
  const std::string why = "caf\xE9.mesh:3: no \"number\"";
  const std::string line = unreadable_line(head, why);
  EXPECT_EQ(read_head(line), head);
  EXPECT_EQ(read_unreadable(line), why);
}

TEST(UnreadableLine, IsNotTheOtherKind) {
  const std::string line = unreadable_line(sample_head(LineHead::Kind::Unreadable), "why");
  EXPECT_THROW(static_cast<void>(read_between(line, sample_names())), InvalidArgument);
  const std::string other =
      between_line(sample_head(LineHead::Kind::Between), sample_findings(), sample_names());
  EXPECT_THROW(static_cast<void>(read_unreadable(other)), InvalidArgument);
}

TEST(BetweenLine, HasTheRowsOfTheReport) {
  const auto object = nlohmann::json::parse(
      between_line(sample_head(LineHead::Kind::Between), sample_findings(), sample_names()));
  EXPECT_EQ(object["name"], "b.mesh");
  EXPECT_EQ(
      object["intersecting_pairs"],
      nlohmann::json::parse(
          R"([["a.mesh", 3, "b.mesh", 17, "crossing"], ["b.mesh", -5, "c.off", 6, "unwelded"]])"));
  EXPECT_EQ(object["contained"], nlohmann::json::parse(R"([["c.off", "b.mesh"]])"));
  EXPECT_EQ(object["closest"],
            nlohmann::json::parse(
                R"([[20, -0.125, "c.off", 6, [1, 0.1, -0.0]], [-30, null, null, null, null]])"));
}

TEST(BetweenLine, KeepsTheFindings) {
  expect_kept(sample_findings(), sample_names());
}

TEST(BetweenLine, WhatWasNotAskedForIsNull) {
  ObjectFindings findings;
  findings.owner = 3;
  expect_kept(findings, sample_names());
  const auto object = nlohmann::json::parse(
      between_line(sample_head(LineHead::Kind::Between), findings, sample_names()));
  for (const char* key : {"intersecting_pairs", "contained", "partly_contained", "closest"}) {
    EXPECT_TRUE(object.at(key).is_null()) << key;
  }
  findings.intersections.emplace();
  findings.separation.emplace();
  expect_kept(findings, sample_names());
}

TEST(BetweenLine, KeepsRandomFindingsBitForBit) {
  std::mt19937_64 random(20);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    ObjectFindings findings;
    findings.owner = random_mesh(random);
    if (random() % 4 != 0) {
      findings.intersections = random_intersections(random);
    }
    if (random() % 4 != 0) {
      findings.separation = random_separation(random);
    }
    expect_kept(findings, sample_names());
  }
}

TEST(BetweenLine, KeepsRealsThatJsonCannotSay) {
  ObjectFindings findings = sample_findings();
  findings.separation->distances[0] = -kInfinity;
  findings.separation->points[0] = {kInfinity, -0.0, -kInfinity};
  expect_kept(findings, sample_names());
}

TEST(BetweenLine, NamesThatDifferInBytesOnlyAreToldApart) {
  expect_kept(sample_findings(), {"\xE9", "\xE8", "\xE9\xE8", "\xEF\xBF\xBD"});
}

TEST(ReadBetween, LineOfOtherMeshesIsRefused) {
  const std::string line =
      between_line(sample_head(LineHead::Kind::Between), sample_findings(), sample_names());
  EXPECT_THROW(static_cast<void>(read_between(line, {"a.mesh", "b.mesh"})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(read_between(line, {"a.mesh", "b.mesh", "d.off"})),
               InvalidArgument);
}

TEST(ReadBetween, LineThatIsCutOffIsRefused) {
  const std::string line =
      between_line(sample_head(LineHead::Kind::Between), sample_findings(), sample_names());
  for (std::size_t length = 0; length + 2 < line.size(); ++length) {
    EXPECT_THROW(static_cast<void>(read_between(line.substr(0, length), sample_names())),
                 InvalidArgument)
        << length;
  }
}

TEST(ReadBetween, BrokenRowsAreRefused) {
  const std::string line =
      between_line(sample_head(LineHead::Kind::Between), sample_findings(), sample_names());
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = line;
    return text.replace(text.rfind(from), from.size(), to);
  };
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"[-30, null", "[-30, 7"},           // a distance to nothing
           {"null, null]", "null]"},            // too short
           {"null]", "null, null]"},            // too long
           {"\"c.off\", 6, [", "\"x\", 6, ["},  // no such mesh
           {"[1, 0.1, -0]", "[1, 0.1]"},        // a point of two coordinates
           {"[1, 0.1, -0]", "[1, null, -0]"},   // which is not finite, but not told how
           {"\"unwelded\"", "\"welded\""},      // no such kind
           {"\"name\": \"b.mesh\"", "\"name\": 1"}}) {
    EXPECT_THROW(static_cast<void>(read_between(changed(from, to), sample_names())),
                 InvalidArgument)
        << to;
  }
}

}  // namespace
}  // namespace meshalyzer
