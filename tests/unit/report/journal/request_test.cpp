#include "meshalyzer/report/journal/request.h"

#include "changed_requests.h"
#include "meshalyzer/base/error.h"
#include "support/constants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace meshalyzer {
namespace {

using test::changed_requests;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The head of a line with these bytes in the place of what was asked.
HeadMembers head_with(const std::string& asked) {
  return HeadMembers(R"({"asked": )" + asked + R"(, "path": "a", "error": ""})");
}

Request read_back(const std::string& asked) {
  return read_request(head_with(asked), "asked");
}

bool is_listed(const std::string& name) {
  const auto requests = changed_requests();
  return std::any_of(requests.begin(), requests.end(),
                     [&](const auto& request) { return request.first == name; });
}

TEST(ChangedRequests, AreOfAllMembers) {
  // One of each part, and those that were once forgotten.
  for (const char* name :
       {".mesh.scope", ".mesh.goodness.edge_length changed", ".mesh.angle_above_degrees changed",
        ".mesh.curvature changed", ".list_offenders", ".is_set", ".between.intersections",
        ".between.separation", ".between.separation.include_self changed changed"}) {
    EXPECT_TRUE(is_listed(name)) << name;
  }
}

TEST(RequestEquality, TellsEveryMember) {
  const auto requests = changed_requests();
  for (const auto& [name, request] : requests) {
    EXPECT_NE(request, Request{}) << name;
    EXPECT_EQ(std::count_if(requests.begin(), requests.end(),
                            [&](const auto& other) { return other.second == request; }),
              1)
        << name;
  }
}

TEST(WriteRequest, KeepsEveryMember) {
  EXPECT_EQ(read_back(request_text({})), Request{});
  for (const auto& [name, request] : changed_requests()) {
    EXPECT_EQ(read_back(request_text(request)), request) << name;
  }
}

TEST(WriteRequest, LeavesOutWhatIsAsByDefault) {
  const auto object = nlohmann::json::parse(request_text({}));
  EXPECT_EQ(object.size(), 1U);
  EXPECT_TRUE(object.contains("version"));
}

TEST(WriteRequest, KeepsRealsToTheLastBit) {
  for (const double real :
       {0.1, 1.0 / 3.0, 1e300, 5e-324, 12345678901234567890.0, -0.0, 7.0, kInfinity, -kInfinity}) {
    Request request;
    request.mesh.shorter_than = real;
    EXPECT_EQ(read_back(request_text(request)), request) << real;
  }
}

TEST(ReadRequest, EarlierKindIsToldPlainly) {
  EXPECT_THAT(
      [] { static_cast<void>(read_back(R"("0.1.0 set -i")")); },
      ThrowsMessage<InvalidArgument>(HasSubstr("written by an earlier version of meshalyzer")));
}

TEST(ReadRequest, OtherVersionIsToldPlainlyWhateverElseItSays) {
  EXPECT_THAT([] { static_cast<void>(read_back(R"({"version": "9.8.7", "mood": "good"})")); },
              ThrowsMessage<InvalidArgument>(
                  HasSubstr("was written by version 9.8.7 of meshalyzer, and this is ")));
}

TEST(ReadRequest, WhatNoRequestSaysIsRefused) {
  const std::string whole = request_text({});
  const auto with = [&](const std::string& members) {
    return whole.substr(0, whole.size() - 1) + ", " + members + "}";
  };
  EXPECT_EQ(read_back(with(R"("is_set": true)")).is_set, true);
  for (const char* members :
       {R"("mood": "good")", R"("mesh": {"mood": 1})", R"("mesh": 1)", R"("is_set": 1)",
        R"("is_set": null)", R"("mesh": {"scope": "all"})", R"("mesh": {"curvature": "round"})",
        R"("mesh": {"longer_than": true})", R"("mesh": {"longer_than": "nan"})",
        R"("mesh": {"longer_than": "1"})", R"("is_set": true, "is_set": true)"}) {
    EXPECT_THROW(static_cast<void>(read_back(with(members))), InvalidArgument) << members;
  }
  for (const char* asked : {"1", "{}", "null", R"({"is_set": true})"}) {
    EXPECT_THROW(static_cast<void>(read_back(asked)), InvalidArgument) << asked;
  }
}

}  // namespace
}  // namespace meshalyzer
